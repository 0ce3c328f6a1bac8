#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
#
# Every public header compiles with LLVM's standard library too, which lacks what no compiler's flag asks about.
# Looks at every compiler: only a clang can use that library, and the newest that has it is asked.
#
# usage: standard_library.sh <folder of the project>       with ANSATZ_SCRATCH in the environment, as ctest sets it
set -euo pipefail
export LC_ALL=C
project=$(cd "${1:-$(dirname "${BASH_SOURCE[0]}")/../..}" && pwd)
scratch=${ANSATZ_SCRATCH:-$(mktemp -d)}
mkdir -p "$scratch"
cd "$scratch"

# The algorithms of std::ranges came with 15.
printf '#include <version>\n#if _LIBCPP_VERSION < 15000\n#error too old\n#endif\n' > asks.cpp
compiler=
for one in clang++-2{1,0} clang++-1{9,8,7,6,5,4} clang++; do
    if command -v "$one" > one.path && "$one" -std=c++20 -stdlib=libc++ -fsyntax-only asks.cpp 2> asks.said; then
        compiler=$one
        break
    fi
done
if [ -z "$compiler" ]; then
    echo "skipped: no clang with libc++ 15 or newer (on Debian: apt install clang-19 libc++-19-dev)"
    exit 0
fi

# Those that stand on a library of their own are left out where it is not there.
while read -r header; do
    needed=
    case $header in
    ansatz/states/scxml*) needed=pugixml.hpp ;;
    ansatz/execution/on_ranks*) needed=mpi.h ;;
    ansatz/world/*) if grep -qE 'needs nlohmann-json|#include <nlohmann' "$project/include/$header"; then needed=nlohmann/json.hpp; fi ;;
    esac
    if [ -n "$needed" ]; then printf '#if __has_include(<%s>)\n#include <%s>\n#endif\n' "$needed" "$header"
    else printf '#include <%s>\n' "$header"; fi
done < <(cd "$project/include" && find ansatz -name '*.hpp' | sort) > every.cpp

eigen=$(pkg-config --cflags-only-I eigen3 2> /dev/null || echo -I/usr/include/eigen3)
if ! "$compiler" -std=c++20 -stdlib=libc++ -fsyntax-only -I"$project/include" $eigen every.cpp 2> said; then
    echo "$compiler with libc++:"
    grep -E 'error' said | head -10
    exit 1
fi
echo "$(grep -c '^#include' every.cpp) headers compile with libc++, by $compiler"
