#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
#
# Two piles in one file take at most 3 % more instructions than each in a file of its own; with seven further worlds in the
# file; and linked behind a file that has all of them, whose copies of the functions the linker takes. Counted by callgrind:
# g++ stops inlining in a file that grows, and what a step calls most is inlined by name against that. As a user compiles (-O3),
# and the seven also as a student debugs (-Og), with the compiler of the build.
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

build() {    # name, options: the object
    local name=$1
    shift
    compile "${CXX:-c++}" "$project/tests/performance/programs/eight_worlds.cpp" "$name.o" -c -DNDEBUG "$@"
}
count() {    # name, objects: their program's instructions
    local name=$1
    shift
    "${CXX:-c++}" "$@" -o "$name"
    valgrind --tool=callgrind --callgrind-out-file="$name.callgrind" "./$name" > "$name.log" 2>&1 || { cat "$name.log"; return 1; }
    sed -nE 's/^==[0-9]+== Collected : ([0-9]+)$/\1/p' "$name.log" > "$name.count"
    [ -s "$name.count" ] || { echo "callgrind counted nothing:"; cat "$name.log"; return 1; }
}
for option in -O3 -Og; do
    start build "two$option" "$option"
    start build "eight$option" "$option" -DANSATZ_EIGHT
done
start build impulse -O3 -DANSATZ_ONLY_IMPULSE
start build substeps -O3 -DANSATZ_ONLY_SUBSTEPS
all_done
for name in two-O3 two-Og eight-O3 eight-Og impulse substeps; do start count "$name" "$name.o"; done
objcopy --redefine-sym main=beside eight-O3.o beside.o
start count linked beside.o two-O3.o
all_done

faults=0
row() {    # what, its count, what it is compared with, and the count of that
    awk -v what="$1" -v n="$2" -v other="$3" -v m="$4" -v limit=$limit 'BEGIN {
        printf "%-42s %12d, %-28s %12d: %.4f, at most %.2f\n", what, n, other, m, n / m, limit
        exit n > limit * m
    }' || faults=$((faults + 1))
}
counted() { cat "$1.count"; }
row "two piles in a file, -O3" "$(counted two-O3)" "each in its own" $(($(counted impulse) + $(counted substeps)))
row "with seven worlds in the file, -O3" "$(counted eight-O3)" "two in a file" "$(counted two-O3)"
row "linked behind the file with all, -O3" "$(counted linked)" "two in a file" "$(counted two-O3)"
row "with seven worlds in the file, -Og" "$(counted eight-Og)" "two in a file" "$(counted two-Og)"
[ $faults -eq 0 ]
