#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
#
# A student's way through one exercise, in a copy of the project with a build of its own: not done, wrong and named,
# broken, right, played with, compared, put aside, and begun anew.
# Looks at every compiler: one such walk on a machine is enough.
#
#   student.sh <the project's folder>
# shellcheck disable=SC2154  # passed, failed, tree and the like are walk.bash's
set -u
# shellcheck source=/dev/null
. "$(dirname "${BASH_SOURCE[0]}")/walk.bash" "$@"

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
    "5 answers that people give are compiled now" "Your numbers equal those of: the position moved with the new velocity." "See 1.6.3." -- exercise 1.6.1
# Whenever they are compiled somebody waits, and is told for what.
rm "$tree"/build/exercises/motion.explicit_euler/{others,wrong.new_velocity} 2> /dev/null
expect 1 "answers that people give are compiled now" "Your numbers equal those of: the position moved with the new velocity." -- exercise
expect 0 "1.6.1 started explicit_euler" -- list

answer 'x += a * dt; v += a * dt;'
expect 1 "the first error is at exercises/1-motion/explicit_euler/exercise.hpp:22" "22 | x += a * dt; v += a * dt;" \
    "this adds or compares quantities of different units: m and m/s" "task exercises/1-motion/explicit_euler/README.md" \
    "next ./workbook exercise explicit_euler, or" -- exercise

# Right in its own words: not the solution's letters, and rounded differently.
answer 'const auto way = dt * v; x = x + way; v = v + dt * a;'
expect 1 "✓ a body that falls in a world" "Task 2 is not done yet" -- exercise
sed -i 's|return todo(2);|return 1.0 + double(omega * dt * omega * dt);|' "$exercise/exercise.hpp"
# What cannot be recorded is not called done.
mv "$tree/.workbook/progress" "$scratch/progress" && mkdir "$tree/.workbook/progress"
expect 1 ".workbook/progress could not be written" -- exercise
rmdir "$tree/.workbook/progress" && mv "$scratch/progress" "$tree/.workbook/progress"
# Only one at a time builds here.
flock "$tree/build/workbook.lock" sleep 2 &
sleep 0.2
expect 0 "another ./workbook is at work in this folder; waiting for it" "Done: every test passes." -- exercise
wait
expect 0 "1.6.1 done explicit_euler" "1 of 1 done" -- list
expect 0 "Every exercise is done." -- exercise
expect 0 "yours -1.39043" "library -1.39043" "ns a body and step" -- play explicit_euler
expect 0 "+ x += v * dt;" "- const auto way" -- diff explicit_euler
expect 0 "nothing is left to hint at" -- hint
expect 0 "hint 1 of 4" -- hint explicit_euler 1 1
# What was done once and then fails in an earlier task is not done for whoever asks for a hint.
cp "$exercise/exercise.hpp" "$scratch/right"
sed -i 's|auto way = dt \* v|auto way = 2 * dt * v|' "$exercise/exercise.hpp"
expect 1 "✗ the position moves with the velocity of the beginning" -- exercise
expect 0 "hint 3 of 4" -- hint
expect 0 "hint 4 of 4" -- hint explicit_euler
cp "$scratch/right" "$exercise/exercise.hpp"
expect 0 "Done: every test passes." -- exercise
expect 0 "nothing is left to hint at" -- hint
# Whatever number a list shows can be typed.
sed -i '1s/1.6.1/2.1.2.2.1/' "$exercise/README.md"
expect 0 "2.1.2.2.1 done explicit_euler" -- list
expect 0 "2.1.2.2.1 Explicit Euler" -- hint 2.1.2.2.1 1 1
sed -i '1s/2.1.2.2.1/1.6.1/' "$exercise/README.md"
expect 0 "first verdict" "known mistakes" "save to verdict" -- doctor
ANSATZ_WATCH_ONCE=true expect 0 "Done: every test passes." -- watch explicit_euler

cp "$exercise/exercise.hpp" "$scratch/right"
sed -i 's|^    return 1.0 +.*|&|; s|const auto way|static int n = 0; if (++n > 1000) std::_Exit(0); const auto way|' "$exercise/exercise.hpp"
expect 1 "your answer ended the program (exit) before the scene was over" -- play explicit_euler
sed -i 's|std::_Exit(0)|{ std::signal(SIGTERM, SIG_IGN); for (volatile int i = 0;; i = i + 1) {} }|; /^#pragma once/a #include <csignal>' "$exercise/exercise.hpp"
ANSATZ_PLAY_SECONDS=1 expect 1 "the scene did not come to an end within 1 s" -- play explicit_euler
sed 's|^ *using role|  using   role|' "$scratch/right" > "$exercise/exercise.hpp"
expect 0 "+ x += v * dt;" -- diff explicit_euler
"$tree/workbook" diff explicit_euler | grep -q '^[-+].*role' && { failed=$((failed + 1)); echo "FAILED: diff shows a line that differs in spaces only"; }
# What was done stays done, though the build folder is gone.
rm -rf "$tree/build"
expect 0 "1.6.1 done explicit_euler" -- list

expect 0 "what you wrote is in .workbook/attempts/motion.explicit_euler-" "is a skeleton again" -- reset explicit_euler
grep -q 'const auto way' "$tree"/.workbook/attempts/*.hpp || { failed=$((failed + 1)); echo "FAILED: what was put aside is not what was written"; }
cmp -s "$exercise/exercise.hpp" "$scratch/skeleton" || { failed=$((failed + 1)); echo "FAILED: reset did not bring the skeleton back"; }
expect 0 "nothing to do" -- reset explicit_euler
# Begun anew is not done, and the next that is not done is this one again.
expect 0 "1.6.1 started explicit_euler" -- list
expect 0 "hint 1 of 4" -- hint explicit_euler 1 1
expect 2 "two digits at most" -- hint explicit_euler 1 99999999999999999999
printf 'motion.explicit_euler\t1\t99999999999999999999\n' >> "$tree/.workbook/hints"
expect 0 "hint 2 of 4" -- hint explicit_euler 2 2
expect 0 "of 4" -- hint explicit_euler 1

# The path that is printed is a name as well; every verb takes as many as it says.
expect 0 "nothing to do" -- reset exercises/1-motion/explicit_euler/exercise.hpp
for verb in verify diff exercise play reset; do expect 2 "what is 'rest'?" -- $verb explicit_euler rest; done
# A file that is gone is named, whatever the verb, and nothing else is said.
gone() { # <file> <arguments...>
    mv "$exercise/$1" "$scratch/gone"
    expect 1 "workbook: exercises/1-motion/explicit_euler/$1 is not there" -- "${@:2}"
    mv "$scratch/gone" "$exercise/$1"
}
gone exercise.hpp exercise explicit_euler
gone exercise.hpp play explicit_euler
gone test.cpp exercise explicit_euler
gone hints.md hint explicit_euler
gone play.cpp play explicit_euler
gone solution.hpp diff explicit_euler --anyway
gone solution.hpp reset explicit_euler
gone library.hpp verify explicit_euler
gone README.md verify

# A wrong answer that does not compile, crashes, ends the program or defines a macro harms no other. One
# that cannot be made is refused with its place.
cp "$exercise/wrong.diff" "$scratch/wrong.diff"
wrong_answer() { # <name> <lines in the place of v += a * dt;>
    printf '\n=== %s\nMistake: %s\nWhy:     A test.\nRead:    1.6.1\nFails:   velocity-adds-up, fall\n@@\n-        v += a * dt;\n' "$1" "$1"
    printf '+%s\n' "${@:2}"
} >> "$exercise/wrong.diff"
wrong_answer a_macro '#define expect_near(...) (void)0' '#undef TEST_CASE' '        v += 3 * a * dt;'
wrong_answer crashes '        int* p = nullptr;' '        *p = 1;'
wrong_answer does_not_compile '        v += a * dt' '        }'
wrong_answer ends_the_program '        std::_Exit(0);'
expect 1 "wrong.does_not_compile should fail [velocity-adds-up] by a check, but it is 'missing': it does not compile: wrong.does_not_compile.hpp" \
    "wrong.crashes should fail [velocity-adds-up] by a check, but it is 'crashed'" \
    "wrong.ends_the_program should fail [velocity-adds-up] by a check, but it is 'ended'" \
    "wrong.a_macro pass fail fail pass wrong.crashes" "wrong.new_velocity fail pass fail pass" "solution pass pass pass pass" \
    -- verify explicit_euler
"$tree/workbook" verify explicit_euler 2>&1 | grep -q 'a_macro.*should\|a_macro passes' && { failed=$((failed + 1)); echo "FAILED: a macro of a wrong answer has changed what is asked of it"; }
answer 'x += v * dt; v += 3 * a * dt;'
expect 1 "Your numbers equal those of: a_macro." -- exercise explicit_euler
wrong_answer nowhere '        v = v;'
sed -i '/^=== nowhere/,$s/^-.*/-        v *= 2;/' "$exercise/wrong.diff"
expect 1 "wrong.diff:$(($(grep -n '^=== nowhere' "$exercise/wrong.diff" | cut -d : -f 1) + 5)): error: nowhere: these lines are not in solution.hpp: 'v *= 2;'" \
    -- verify explicit_euler
cp "$scratch/wrong.diff" "$exercise/wrong.diff"

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
