#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
#
# Answers that are broken in every way that people find: what does not compile or makes no program, what crashes, hangs,
# ends the program, prints or takes too much. Each must be said in its own sentence, and none may pass.
# Looks at every compiler: one such walk on a machine is enough.
#
#   answers.sh <the project's folder>
# shellcheck disable=SC2154  # passed, failed, tree and the like are walk.bash's
set -u
# shellcheck source=/dev/null
. "$(dirname "${BASH_SOURCE[0]}")/walk.bash" "$@"

answer 'return; }; static double riddle() {'
expect 1 "the function ends without return" -- exercise
answer 'auto w = v; { double unset; w *= unset; } x += w * dt;'
expect 1 "is used uninitialized" -- exercise
sed '$d' "$scratch/skeleton" > "$exercise/exercise.hpp"
expect 1 "the first error is at the end of exercises/1-motion/explicit_euler/exercise.hpp" "closing brace } is missing" -- exercise
{ cat "$scratch/skeleton"; echo 'int main() {}'; } > "$exercise/exercise.hpp"
expect 1 "it compiles, but it makes no program" "there are two of main" -- exercise
{ cat "$scratch/skeleton"; echo 'struct Global { Global() { std::abort(); } }; inline Global global;'; } > "$exercise/exercise.hpp"
expect 1 "your answer cannot be tested: It was aborted" "That was before main" -- exercise

# What an answer prints or ends with is no verdict.
{ sed '/^#pragma once/a #include <cstdio>\n#include <cstdlib>' "$scratch/skeleton"
    printf '%s\n' 'inline int global = std::puts("1\tfall\ta test that nobody wrote");'; } > "$exercise/exercise.hpp"
expect 1 "✗ the position moves with the velocity of the beginning" "Task 1 is not done yet" -- exercise
{ cat "$scratch/skeleton"; echo 'inline int global = (std::_Exit(0), 0);'; } > "$exercise/exercise.hpp"
expect 1 "your answer cannot be tested: It ended the program (exit) before main" -- exercise
for way in 'std::exit(0);' 'std::_Exit(10);'; do
    answer "$way"
    expect 1 "It ended the program (exit) before the test was over." -- exercise
done
answer 'for (;;) std::fputs("a line of so and so many letters, again and again and again and again\\n", stdout);'
expect 1 "It printed more than 20 MB" -- exercise
answer 'static std::vector<double> much(std::size_t(1) << 30); x += much[0] * v * dt;'
expect 1 "It asked for more than 4 GB of memory" -- exercise
answer 'std::abort();'
expect 1 "It was aborted: something called std::abort()" -- exercise
expect 0 "1.6.1 started explicit_euler" -- list

# Macros of an answer mean nothing to the tests, be they in it or in a file beside it.
for macro in 'FAIL(...) (void)0' 'expect_near(...) (void)0' 'TEST_CASE(...) inline void nothing()' 'abs(x) 0 * (x)' 'metres metres_of'; do
    answer 'v += a * dt; x += v * dt;'
    printf '#  define \\\n    %s\n' "$macro" >> "$exercise/exercise.hpp"
    expect 1 "✗ the position moves with the velocity of the beginning" "yours (1.305, 2.3, 0) m" -- exercise
done
printf '#pragma once\n#define expect_near(...) (void)0\n' > "$exercise/beside.hpp"
echo '#include "beside.hpp"' >> "$exercise/exercise.hpp"
expect 1 "✗ the position moves with the velocity of the beginning" -- exercise
rm "$exercise/beside.hpp"
# Nor does it help to write where the verdict is written: at the beginning, at the end, or with what stands there.
cp "$project/tests/exercises/forger.hpp" "$exercise/"
for when in BEGINNING END AT_EXIT ALL_FILES; do
    answer 'v += a * dt; x += v * dt;'
    printf '#define FORGE_%s\n#include "forger.hpp"\n' "$when" >> "$exercise/exercise.hpp"
    output=$("$tree/workbook" exercise explicit_euler 2>&1 < /dev/null)
    if [ $? -eq 1 ] && ! grep -q '✓\|Done' <<< "$output"; then passed=$((passed + 1))
    else failed=$((failed + 1)); printf 'FAILED: a verdict was forged (%s):\n%s\n' "$when" "$output"; fi
done
rm "$exercise/forger.hpp"
expect 0 "1.6.1 started explicit_euler" -- list

# A wrong unit in a return is one sentence, with its units.
{ cat "$scratch/skeleton"; echo 'inline Quantity<unit::Frequency> f(Quantity<unit::Frequency> a) { return a * a; }'; } > "$exercise/exercise.hpp"
expect 1 "this is a quantity in 1/s^2, where a quantity in 1/s belongs" -- exercise

# Ctrl-C stops at once, and says so, though the program of the answer has a group of its own.
answer 'for (volatile int i = 0;; i = i + 1) {}'
(set -m; ANSATZ_CPU_SECONDS=60 "$tree/workbook" exercise > "$scratch/stopped" 2>&1 < /dev/null & echo $! > "$scratch/pid"; wait) &
walk=$!
for ((i = 0; i < 1200; i++)); do [ "$tree/build/exercises/motion.explicit_euler/student" -nt "$exercise/exercise.hpp" ] && break; sleep 0.1; done
sleep 1      # now it has been built, and hangs
start=$SECONDS
kill -INT -- "-$(cat "$scratch/pid")"
wait "$walk"
if [ $((SECONDS - start)) -le 3 ] && grep -q 'stopped; nothing is left half done' "$scratch/stopped"; then passed=$((passed + 1))
else failed=$((failed + 1)); echo "FAILED: Ctrl-C took $((SECONDS - start)) s and said: $(cat "$scratch/stopped")"; fi

answer 'int* p = nullptr; *p = 1; x += v * dt;'
expect 1 "It crashed (segmentation fault)" -- exercise
answer 'for (volatile int i = 0;; i = i + 1) {}'
expect 1 "It did not come to an end within 1 s" -- exercise
answer 'x += std::sqrt(-1.0) * v * dt;'
expect 1 "Yours is no finite number" "yours (not a number, not a number, not a number) m" -- exercise
answer 'throw std::out_of_range("nobody expects this");'
expect 1 "It threw an exception: nobody expects this" -- exercise

# What is made for an exercise includes by place, not by whole path: with ccache the lists of included files are shared by
# all checkouts, and a change of exercise.hpp would be looked for in another one. Each of the files must be there by now.
grep -n '#include "/' "$tree"/build/exercises/motion.explicit_euler/{student.cpp,subject.hpp,subjects.cpp}
if [ $? -eq 1 ]; then passed=$((passed + 1)); else failed=$((failed + 1)); echo "FAILED: these include by a whole path"; fi

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
