#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
# Looks at every compiler that is here.
#
# A check that cannot fail checks nothing. A fault is planted for each kind, beside the same thing without it: the first must
# be refused, for its own reason, and the second must pass. The kinds with a test of their own are not here again: sentences
# (tools.must_not_compile), wrong answers that pass (exercises.verify), what the five trees hold (tools.mirror), what pages quote and
# show (tools.planted_pages, tools.docs).
#
# The flags of the sanitizers are those of CMakePresets.json, so whoever switches one off there is told here.
#
#   planted.sh <the project's folder>     with ANSATZ_SCRATCH in the environment, as ctest sets it
set -euo pipefail
export LC_ALL=C
project=$(cd "$1" && pwd)
mkdir -p "$ANSATZ_SCRATCH"
cd "$ANSATZ_SCRATCH"
command -v clang++ > /dev/null || { echo "skipped: no clang++ (on Debian: apt install clang)"; exit 0; }
passed=0

# <what> <good or the words of the refusal> <command...>
expect() {
    local what=$1 words=$2 said status=0
    shift 2
    said=$("$@" 2>&1) || status=$?
    if [ "$words" = good ]; then
        [ $status -eq 0 ] || { printf 'refused, and holds no fault: %s:\n%s\n' "$what" "$said"; exit 1; }
    else
        [ $status -ne 0 ] || { printf 'a planted fault went unseen: %s\n' "$what"; exit 1; }
        grep -q -e "$words" <<< "$said" || { printf 'refused, but without "%s": %s:\n%s\n' "$words" "$what" "$said"; exit 1; }
    fi
    passed=$((passed + 1))
}

# ---------------------------------------------------------------- a header that does not compile alone, or not twice
alone() { printf '#include "%s"\n#include "%s"\n' "$1" "$1" > alone.cpp && "${CXX:-c++}" -std=c++20 -I . -fsyntax-only alone.cpp; }
printf '#pragma once\n#include <vector>\ninline std::vector<int> some;\n' > whole.hpp
printf '#pragma once\ninline std::vector<int> some;\n' > lacking.hpp
printf '#include <vector>\ninline std::vector<int> some;\n' > twice.hpp
expect "a header" good alone whole.hpp
expect "a header that lacks an include" "vector" alone lacking.hpp
expect "a header without a guard" "redefinition" alone twice.hpp

# ---------------------------------------------------------------- memory, and numbers: the stage ci-sanitize
read -ra flags < <(awk '/"name": "ci-sanitize"/ { there = 1 } there && /CMAKE_CXX_FLAGS_DEBUG/ { split($0, part, "\""); print part[4]; exit }' \
    "$project/CMakePresets.json")
[[ ${flags[*]} == *-fsanitize=address* ]] || { echo "no flags of the sanitizers in CMakePresets.json"; exit 1; }
clang++ -std=c++20 "${flags[@]}" "$project/tests/tools/planted/memory.cpp" -o memory
ctest_says() { ASAN_OPTIONS=detect_stack_use_after_return=1 ./memory "$@"; }
expect "no fault" good ctest_says none
expect "an index one behind the end" "heap-buffer-overflow" ctest_says off_by_one
expect "memory that nobody frees" "LeakSanitizer" ctest_says leak
expect "memory that was freed" "heap-use-after-free" ctest_says freed
expect "the stack of a function that has returned" "stack-use-after-return" ctest_says returned
expect "an int that overflows" "signed integer overflow" ctest_says overflow
expect "an element behind a vector's size, within its memory" "__n < this->size()" ctest_says beyond_size

echo "$passed faults and their opposites judged rightly"
