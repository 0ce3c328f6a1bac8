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
    "Your numbers equal those of: the position moved with the new velocity." "See 1.6.3." -- exercise 1.6.1
expect 0 "1.6.1 started explicit_euler" -- list

answer 'x += a * dt; v += a * dt;'
expect 1 "the first error is at exercises/1-motion/explicit_euler/exercise.hpp:22" "22 | x += a * dt; v += a * dt;" \
    "this adds or compares quantities of different units: m and m/s" -- exercise

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

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
