#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
# Looks at every compiler that is here.
#
# How many instructions a step executes, counted exactly by callgrind:
#
#   - free flight and fall (gravity) of 20,000 bodies in a World, against the loop over lanes that one writes by hand:
#     at most 2 % more, in float and double, in two dimensions and three (hard case N4)
#   - 20,000 awake bodies with 20,000 resting ones beside them, against the same awake ones alone: less than 1 % more
#   - 200 balls that roll and collide, with 10,000 fixed ones out of their way, or with 10,000 that sleep on the same
#     ground, against the 200 alone: at most 1.3 times
#   - balls that all sleep on the ground, 5,000 against 1,000: as many instructions a step
#   - one of them wakes, hops and falls asleep again: at most 1.05 times
#   - 200 that swing on springs beside 10,000 that hang on springs asleep, against the 200 alone: at most 1.3 times;
#     and 5,000 that all hang asleep against 1,000: as many instructions a step
#
# Those of collisions with two responses: Impulse with Projection, and SoftSubsteps, which owns substeps; those of springs
# without collisions, and with SoftSubsteps.
#
# With every compiler found, for x86-64-v3 (AVX2), since valgrind does not know AVX-512. The bodies and the two ways to
# step them are in instructions.hpp.
#
# usage: instructions.sh <folder of the project>       with CXX and ANSATZ_SCRATCH in the environment, as ctest sets them
set -euo pipefail
export LC_ALL=C
project=$(cd "${1:-$(dirname "${BASH_SOURCE[0]}")/../..}" && pwd)
source "$project/tests/programs.bash"
flight_limit=1.02 rest_limit=1.01 level_limit=1.3 wake_limit=1.05

command -v valgrind callgrind_annotate > /dev/null || skip "no valgrind (on Debian: apt install valgrind)"
[ "$(uname -m)" = x86_64 ] || skip "the loops are compared on x86-64, and this is $(uname -m)"
grep -qw avx2 /proc/cpuinfo || skip "this processor has no AVX2"

scratch=${ANSATZ_SCRATCH:-$(mktemp -d)}
mkdir -p "$scratch"
cd "$scratch"
printf '#include "tests/performance/instructions.hpp"\nint main() { ansatz::counted::count_all(); }\n' > instructions.cpp

count() {    # compiler
    local compiler
    compiler=$(basename "$1")
    compile "$1" instructions.cpp "instructions-$compiler" -O3 -DNDEBUG -march=x86-64-v3
    valgrind --tool=callgrind --callgrind-out-file="$compiler.callgrind" "./instructions-$compiler" > "$compiler.log" 2>&1 ||
        { cat "$compiler.log"; return 1; }
    callgrind_annotate --inclusive=yes --auto=no --threshold=100 "$compiler.callgrind" > "$compiler.functions"
}
mapfile -t compilers < <(found_compilers)
for compiler in "${compilers[@]}"; do start count "$compiler"; done
all_done
compilers=("${compilers[@]##*/}")

faults=0
# Instructions of one function, callees included: <compiler> <its name, as an extended regex>
counted() {
    local n
    n=$(sed -nE "s/^ *([0-9,]+) .*[ :]$2.*/\1/p" "$1.functions" | head -n 1 | tr -d ,)
    [ -n "$n" ] || { echo "callgrind names no function $2" >&2; exit 1; }
    echo "$n"
}
# The same for each body and step
instructions_of() { counted "$1" "$2" | awk '{ printf "%.4f", $1 / 20000 / 100 }'; }
row() {    # compiler, what, the reference's function, ours, the limit of ours to the reference's
    local reference ours verdict=holds
    reference=$(instructions_of "$1" "$3")
    ours=$(instructions_of "$1" "$4")
    if ! awk -v a="$ours" -v b="$reference" -v limit="$5" 'BEGIN { exit !(b > 0 && a <= limit * b) }'; then
        verdict='TOO MANY'
        faults=$((faults + 1))
    fi
    awk -v c="$1" -v w="$2" -v a="$reference" -v b="$ours" -v l="$5" -v v="$verdict" \
        'BEGIN { printf "%-12s %-24s %9.3f %9.3f %8.4f %7.2f  %s\n", c, w, a, b, b / a, l, v }'
}

echo "instructions for each body and step (callgrind), -O3 -DNDEBUG -march=x86-64-v3 -ffp-contract=off -fno-math-errno"
head="%-12s %-24s %9s %9s %8s %7s\n"
# shellcheck disable=SC2059 # the format is a variable on purpose
printf "\n$head" compiler "" "by hand" World ratio limit
for compiler in "${compilers[@]}"; do
    for scalar in float double; do
        for dimension in 2 3; do
            kind="$scalar, $dimension" name="$scalar, $dimension-D"
            row "$compiler" "free flight, $name" "by_hand<$kind, false" "by_world<$kind, false" "$flight_limit"
            row "$compiler" "fall, $name" "by_hand<$kind, true" "by_world<$kind, true" "$flight_limit"
        done
    done
done
# shellcheck disable=SC2059
printf "\n$head" compiler "" "without" "with" ratio limit
for compiler in "${compilers[@]}"; do
    row "$compiler" "10,000 hang" "swinging_alone<.*Rest>" "swinging_beside_sleepers<.*Rest>" "$level_limit"
    row "$compiler" "10,000 hang, SoftSubsteps" "swinging_alone<.*SoftSubsteps" "swinging_beside_sleepers<.*SoftSubsteps" "$level_limit"
    row "$compiler" "20,000 resting bodies" "awake_alone<" "awake_beside_resting<" "$rest_limit"
    for response in Impulse SoftSubsteps; do
        row "$compiler" "10,000 fixed, $response" "rolling_alone<.*$response" "rolling_in_a_level<.*$response" "$level_limit"
        row "$compiler" "10,000 asleep, $response" "rolling_alone<.*$response" "rolling_beside_sleepers<.*$response" "$level_limit"
        row "$compiler" "one wakes, $response" "waking_among_few<.*$response" "waking_among_many<.*$response" "$wake_limit"
    done
done
printf '\n%-12s %-24s %9s %9s\n' compiler "a step, all asleep" 1,000 5,000
same() {    # compiler, what, the functions of 1,000 and of 5,000 without their prefix
    local few many verdict=same
    few=$(counted "$1" "$3_few<.*$4") many=$(counted "$1" "$3_many<.*$4")
    if [ "$few" != "$many" ]; then
        verdict=DIFFER
        faults=$((faults + 1))
    fi
    awk -v c="$1" -v r="$2" -v f="$few" -v m="$many" -v v="$verdict" \
        'BEGIN { printf "%-12s %-24s %9.0f %9.0f  %s\n", c, r, f / 100, m / 100, v }'
}
for compiler in "${compilers[@]}"; do
    for response in Impulse SoftSubsteps; do same "$compiler" "$response" asleep "$response"; done
    same "$compiler" "on springs" hanging "Rest>"
    same "$compiler" "on springs, SoftSubsteps" hanging SoftSubsteps
done

if [ $faults -gt 0 ]; then
    printf '\n%d of these are above their limit; callgrind_annotate %s/<compiler>.callgrind shows where the instructions go\n' $faults "$scratch"
    exit 1
fi
