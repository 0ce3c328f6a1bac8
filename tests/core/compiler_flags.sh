#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
#
# Flags under which NaN and infinity are no longer told from numbers, or sums are reordered, are refused by every public header,
# whichever a program includes first, before anything else can be read; the flags of the exported target are not.
#
# usage: compiler_flags.sh <folder of the project>       with CXX and ANSATZ_SCRATCH in the environment, as ctest sets them
set -euo pipefail
export LC_ALL=C
project=$(cd "${1:-$(dirname "${BASH_SOURCE[0]}")/../..}" && pwd)
scratch=${ANSATZ_SCRATCH:-$(mktemp -d)}
mkdir -p "$scratch"
cd "$scratch"

eigen=$(pkg-config --cflags eigen3 2> /dev/null || echo -I/usr/include/eigen3)
compiler=${CXX:-g++}
faults=0
# Only the preprocessor runs: it is there that they are refused.
reads() {    # <header> <flag>...
    local header=$1
    shift
    "$compiler" -std=c++20 "$@" -Wfatal-errors -E -o /dev/null -x c++ -I"$project/include" $eigen "$project/include/$header" 2> said
}
refused() {    # <header> <flag>...
    if reads "$@"; then
        echo "$1 accepts ${*:2}"
    elif ! grep -m 1 'error: ' said | grep -qF "Ansatz: ${said_of:-$2} is refused"; then
        echo "$1 with ${*:2}: the first error is not the sentence that refuses it:"
        head -3 said
    else
        return 0
    fi
    faults=$((faults + 1))
}

# A header that includes one of the library refuses what that one does, and the last of such a chain includes no other than
# <ansatz/core/compiler_flags.hpp>: those last ones are asked.
mapfile -t headers < <(cd "$project/include" && find ansatz -name '*.hpp' ! -path ansatz/core/compiler_flags.hpp | sort)
refused ansatz/core/compiler_flags.hpp -ffinite-math-only
for header in "${headers[@]}"; do
    mapfile -t included < <(sed -nE 's/^ *# *include *<(ansatz\/[^>]+)>.*/\1/p' "$project/include/$header")
    case "${included[*]}" in
    '')
        echo "$header includes nothing of the library, so it refuses no flag: include <ansatz/core/compiler_flags.hpp>"
        faults=$((faults + 1)) ;;
    ansatz/core/compiler_flags.hpp) refused "$header" -ffinite-math-only ;;
    esac
done
refused ansatz/states.hpp -ffast-math
refused ansatz/paths.hpp -ffast-math
refused ansatz/units.hpp -ffast-math
said_of=-ffast-math refused ansatz/world.hpp -Ofast
# What it is made of; clang does not say by any macro that it was asked for them.
if ! "$compiler" --version | grep -q clang; then
    refused ansatz/world.hpp -funsafe-math-optimizations
    said_of=-funsafe-math-optimizations refused ansatz/world.hpp -ffast-math -fno-finite-math-only
    said_of=-freciprocal-math refused ansatz/world.hpp -freciprocal-math
fi
# The same for a standard before C++20.
if reads ansatz/world.hpp -std=c++17 || ! grep -m 1 'error: ' said | grep -qF "compile with -std=c++20 or newer"; then
    echo "C++17 is not refused by a sentence:"
    head -3 said
    faults=$((faults + 1))
fi
if ! reads ansatz/world.hpp -O3 -ffp-contract=off -fno-math-errno; then
    echo "the flags of the exported target are refused:"
    head -3 said
    faults=$((faults + 1))
fi
if [ "$faults" -gt 0 ]; then exit 1; fi
echo "${#headers[@]} headers refuse flags that take NaN away"
