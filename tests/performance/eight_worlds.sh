#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
#
# Two piles in a file with seven further worlds take at most 3 % more instructions than in a file of their own, counted by
# callgrind: g++ stops inlining in a file that grows, and what a step calls most is flattened against that. As a user compiles
# (-O3) and as a student debugs (-Og), with the compiler of the build.
#
# usage: eight_worlds.sh <folder of the project>       with CXX and ANSATZ_SCRATCH in the environment, as ctest sets them
set -euo pipefail
export LC_ALL=C
project=$(cd "${1:-$(dirname "${BASH_SOURCE[0]}")/../..}" && pwd)
source "$project/tests/programs.bash"
limit=1.03

command -v valgrind > /dev/null || skip "no valgrind (on Debian: apt install valgrind)"
scratch=${ANSATZ_SCRATCH:-$(mktemp -d)}
mkdir -p "$scratch"
cd "$scratch"

count() {    # name, options
    local name=$1
    shift
    compile "${CXX:-c++}" "$project/tests/performance/programs/eight_worlds.cpp" "$name" -DNDEBUG "$@"
    valgrind --tool=callgrind --callgrind-out-file="$name.callgrind" "./$name" > "$name.log" 2>&1 || { cat "$name.log"; return 1; }
    sed -nE 's/^==[0-9]+== Collected : ([0-9]+)$/\1/p' "$name.log" > "$name.count"
    [ -s "$name.count" ] || { echo "callgrind counted nothing:"; cat "$name.log"; return 1; }
}
options=(-O3 -Og)
for option in "${options[@]}"; do
    start count "alone$option" "$option"
    start count "eight$option" "$option" -DANSATZ_EIGHT
done
all_done

faults=0
for option in "${options[@]}"; do
    awk -v option="$option" -v alone="$(cat "alone$option.count")" -v eight="$(cat "eight$option.count")" -v limit=$limit 'BEGIN {
        printf "%-4s alone %12d, with seven others %12d: %.4f, at most %.2f\n", option, alone, eight, eight / alone, limit
        exit eight > limit * alone
    }' || faults=$((faults + 1))
done
[ $faults -eq 0 ]
