#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
#
# The loops of a step run on several threads (docs/world.md, "An execution of your own") without a data race: the thread
# sanitizer has nothing to say about programs/threads.cpp, and it does speak where a race is planted.
#
# usage: threads.sh <folder of the project>       with CXX and ANSATZ_SCRATCH in the environment, as ctest sets them
set -euo pipefail
project=$(cd "${1:-$(dirname "${BASH_SOURCE[0]}")/../..}" && pwd)
source "$project/tests/programs.bash"

scratch=${ANSATZ_SCRATCH:-$(mktemp -d)}
mkdir -p "$scratch"
cd "$scratch"
compiler=${CXX:-c++}
flags=(-O1 -g1 -fsanitize=thread -pthread)

printf '#include <thread>\nint main() { int n = 0; std::thread([&] { n = 1; }).join(); return n - 1; }\n' > probe.cpp
"$compiler" -std=c++20 "${flags[@]}" probe.cpp -o probe > /dev/null 2>&1 || skip "$compiler has no thread sanitizer"
# Some kernels lay memory out where the sanitizer's shadow must lie; without that layout it runs there, too.
run=()
if ! ./probe > /dev/null 2>&1; then
    run=(setarch "$(uname -m)" -R)
    "${run[@]}" ./probe > /dev/null 2>&1 || skip "programs with the thread sanitizer do not run on this kernel"
fi

compile "$compiler" "$project/tests/world/programs/threads.cpp" threads "${flags[@]}"
compile "$compiler" "$project/tests/world/programs/threads.cpp" race "${flags[@]}" -DANSATZ_RACE

if ! "${run[@]}" ./threads > threads.log 2>&1 || grep -q "WARNING: ThreadSanitizer" threads.log; then
    head -60 threads.log | cut -c 1-200
    echo "a data race, or other bits on three threads than on one"
    exit 1
fi
if "${run[@]}" ./race > race.log 2>&1 || ! grep -q "WARNING: ThreadSanitizer: data race" race.log; then
    echo "the sanitizer does not see the race that is planted in programs/threads.cpp"
    exit 1
fi
cat threads.log
