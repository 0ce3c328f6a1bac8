#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
#
# A bare machine has make and no ccache, as ./workbook leaves it; ours has ninja and ccache. The commands that CMake writes for such
# a machine have no empty word among them, which would be called as a program, and all answers to an exercise go through
# tools/exercises/compile.sh to the compiler. And the headers of whole modules, which the mistakes that must not compile read at
# once, need nothing but Boost and Eigen: all but execution.hpp, which needs oneTBB.
#
#   bare_machine.sh <the project's folder>     with ANSATZ_SCRATCH in the environment, as ctest sets it
set -euo pipefail
project=${1:?the project folder}
scratch=${ANSATZ_SCRATCH:?a folder for this test}
for tool in cmake make; do
    if ! command -v "$tool" > /dev/null; then echo "skipped: no $tool (on Debian: apt install cmake make)"; exit; fi
done
rm -rf "$scratch" && mkdir -p "$scratch"
unset CMAKE_GENERATOR CMAKE_CXX_COMPILER_LAUNCHER
(cd "$project" && cmake --preset release -G "Unix Makefiles" -B "$scratch/build" -DANSATZ_CCACHE=OFF) > "$scratch/log" 2>&1 ||
    { cat "$scratch/log"; exit 1; }

if grep -rn --include=build.make -E '^	.*(&&|;) .* "" ' "$scratch/build" > "$scratch/empty"; then
    echo "FAILED: commands with an empty word, $(wc -l < "$scratch/empty") of them; the first:"
    head -n 1 "$scratch/empty" | cut -c 1-400
    exit 1
fi
shopt -s nullglob
answers=("$scratch"/build/exercises/CMakeFiles/exercise.*.others.dir/build.make)
if [ ${#answers[@]} -eq 0 ]; then echo "skipped: this build has no exercises"; exit; fi
compiler=$(sed -n 's/^CMAKE_CXX_COMPILER:[A-Z]*=//p' "$scratch/build/CMakeCache.txt")
for rules in "${answers[@]}"; do
    grep -q -F "tools/exercises/compile.sh $compiler " "$rules" || { echo "FAILED: $rules does not hand $compiler to compile.sh"; exit 1; }
done
echo "${#answers[@]} exercises are compiled by $compiler, without ccache"

cd "$project/include/ansatz"
for header in *.hpp; do [ "$header" = execution.hpp ] || printf '#include <ansatz/%s>\n' "$header"; done > "$scratch/modules.cpp"
"$compiler" -std=c++20 -M -MG -I "$project/include" -isystem /usr/include/eigen3 "$scratch/modules.cpp" > "$scratch/includes"
if grep -o -E '[^ ]*(/(tbb|oneapi|nlohmann|catch2|benchmark|boost/mpi)/|pugixml)[^ ]*' "$scratch/includes" > "$scratch/more"; then
    echo "FAILED: the headers of modules include what a machine need not have: $(head -n 3 "$scratch/more" | tr '\n' ' ')"
    exit 1
fi
