#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
#
# A student's way through one exercise, in a copy of the project with a build of its own: not done, wrong and named,
# broken, right, played with, compared, put aside, and begun anew.
# Looks at every compiler: one such walk on a machine is enough.
#
#   student.sh <the project's folder>
set -u
project=${1:?the project folder}
scratch=${ANSATZ_SCRATCH:?a folder for this test}
tree=$scratch/a\ copy
rm -rf "$scratch" && mkdir -p "$tree/exercises/1-motion" || exit 1
cp -R "$project"/{CMakeLists.txt,CMakePresets.json,README.md,workbook,cmake,include,chapters,tools} "$tree/" || exit 1
mkdir -p "$tree/tests" && cp "$project/tests/catch.hpp" "$tree/tests/" || exit 1
cp "$project"/exercises/{CMakeLists.txt,precompiled.cpp} "$tree/exercises/" && cp -R "$project/exercises/1-motion/explicit_euler" "$tree/exercises/1-motion/" || exit 1
cp "$project/exercises/.clang-format" "$tree/exercises/" 2> /dev/null
exercise=$tree/exercises/1-motion/explicit_euler
awk -f "$project/tools/exercises/skeleton.awk" "$exercise/solution.hpp" > "$exercise/exercise.hpp"

passed=0
failed=0
unset COLUMNS NO_COLOR CI
export ANSATZ_CPU_SECONDS=1
# expect <code> <text...> -- <arguments>: every text must be there.
expect() {
    local code=$1 output status texts=() text
    shift
    while [ "$1" != -- ]; do texts+=("$1"); shift; done
    shift
    output=$(cd / && COLUMNS=200 "$tree/workbook" "$@" 2>&1 < /dev/null)
    status=$?
    output=$(printf '%s' "$output" | tr '\n' ' ' | tr -s ' ')
    for text in "${texts[@]}"; do
        case $output in
            *"$text"*) [ $status -eq "$code" ] && { passed=$((passed + 1)); continue; } ;;
        esac
        failed=$((failed + 1))
        printf 'FAILED: workbook %s: expected code %s and "%s", got code %s and:\n    %s\n' "$*" "$code" "$text" "$status" "$output"
    done
}
answer() { sed "s|todo(1);|$1|" "$scratch/skeleton" > "$exercise/exercise.hpp"; }
cp "$exercise/exercise.hpp" "$scratch/skeleton"

expect 0 "1.6.1 open explicit_euler" "0 of 1 done" -- list
expect 2 "did you mean explicit_euler?" -- exercise explcit_euler
expect 1 "Task 1 is not done yet: it waits at exercises/1-motion/explicit_euler/exercise.hpp:22" -- exercise
expect 0 "1.6.1 open explicit_euler" -- list
expect 0 "hint 1 of 4" "which velocity is known" -- hint
expect 0 "hint 2 of 4" -- hint
expect 0 "hint 4 of 4" "1 + (omega dt)^2" -- hint explicit_euler 2 4
expect 2 "has no task 9" -- hint explicit_euler 9
expect 1 "not done yet: task 1" "./workbook exercise explicit_euler first" -- play explicit_euler
expect 1 "This exercise is not done yet" -- diff explicit_euler

answer 'v += a * dt; x += v * dt;'
expect 1 "✗ the position moves with the velocity of the beginning" "yours (1.305, 2.3, 0) m right (1.3, 2.4, 0) m" \
    "Your numbers equal those of: the position moved with the new velocity." "See 1.6.3." -- exercise 1.6.1
expect 0 "1.6.1 started explicit_euler" -- list

answer 'x += a * dt; v += a * dt;'
expect 1 "the first error is at exercises/1-motion/explicit_euler/exercise.hpp:22" "22 | x += a * dt; v += a * dt;" \
    "this adds or compares quantities of different units: m and m/s" -- exercise

answer 'int* p = nullptr; *p = 1; x += v * dt;'
expect 1 "It crashed (segmentation fault)" -- exercise
answer 'for (volatile int i = 0;; i = i + 1) {}'
expect 1 "It did not come to an end within 1 s" -- exercise
answer 'x += std::sqrt(-1.0) * v * dt;'
expect 1 "Yours is no finite number" -- exercise
answer 'throw std::out_of_range("nobody expects this");'
expect 1 "It threw an exception: nobody expects this" -- exercise

# Right in its own words: not the solution's letters, and rounded differently.
answer 'const auto way = dt * v; x = x + way; v = v + dt * a;'
expect 1 "✓ a body that falls in a world" "Task 2 is not done yet" -- exercise
sed -i 's|return todo(2);|return 1.0 + double(omega * dt * omega * dt);|' "$exercise/exercise.hpp"
expect 0 "Done: every test passes." -- exercise
expect 0 "1.6.1 done explicit_euler" "1 of 1 done" -- list
expect 0 "Every exercise is done." -- exercise
expect 0 "yours -1.39043" "library -1.39043" "ns a body and step" -- play explicit_euler
expect 0 "+ x += v * dt;" "- const auto way" -- diff explicit_euler
ANSATZ_WATCH_ONCE=true expect 0 "Done: every test passes." -- watch explicit_euler

expect 0 "what you wrote is in .workbook/attempts/motion.explicit_euler-" "is a skeleton again" -- reset explicit_euler
grep -q 'const auto way' "$tree"/.workbook/attempts/*.hpp || { failed=$((failed + 1)); echo "FAILED: what was put aside is not what was written"; }
cmp -s "$exercise/exercise.hpp" "$scratch/skeleton" || { failed=$((failed + 1)); echo "FAILED: reset did not bring the skeleton back"; }
expect 0 "nothing to do" -- reset explicit_euler
# What was done stays done, though the answer is gone and the build folder with it.
rm -rf "$tree/build"
expect 0 "1.6.1 done explicit_euler" -- list

echo "$passed passed, $failed failed"
[ $failed -eq 0 ]
