#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
#
# Whether clang-tidy finds nothing in the library's headers by the rules of .clang-tidy, and whether it finds a planted
# fault. All headers, by way of those of the modules, in one source, so that what modules share is looked at once: half a minute, and
# what changed is among them.
#
# Another version has other rules: it is clang-tidy 16, of Debian's clang-tidy-16.
#
#   tidy.sh <the project's folder>
set -euo pipefail
project=$(cd "${1:?the project folder}" && pwd)
scratch=${ANSATZ_SCRATCH:-$(mktemp -d)}
mkdir -p "$scratch"

tidy=$(command -v clang-tidy-16 || true)
if [ -z "$tidy" ]; then
    echo "skipped: there is no clang-tidy-16 (on Debian: apt install clang-tidy-16)"
    exit
fi
eigen=${EIGEN3_INCLUDE_DIR:-/usr/include/eigen3}

look() {    # a source: what is found in it and in the headers of the project that it includes
    "$tidy" --quiet --config-file="$project/.clang-tidy" --header-filter="($project/include/ansatz|$scratch)/" "$1" -- \
        -std=c++20 -I"$project/include" -isystem "$eigen" 2> "$1.errors" > "$1.found" || true
    grep -E '(warning|error): ' "$1.found" || true
}

planted=$scratch/planted.cpp
printf '#include "planted.hpp"\nint main() {}\n' > "$planted"
printf 'struct Meters {\n    Meters(double m) : m_(m) {}\n    double m_;\n};\n' > "$scratch/planted.hpp"
if [ -z "$(look "$planted")" ]; then
    echo "a converting constructor was not found"
    exit 1
fi

everything=$scratch/everything.cpp
modules=0
threads=yes
echo '#include <oneapi/tbb/parallel_for.h>' | "${CXX:-c++}" -E -x c++ - > /dev/null 2>&1 || threads=
for header in "$project"/include/ansatz/*.hpp; do
    if [ "${header##*/}" = execution.hpp ] && [ -z "$threads" ]; then
        echo "execution.hpp is left out: there is no oneTBB (on Debian: apt install libtbb-dev)"
        continue
    fi
    echo "#include <ansatz/$(basename "$header")>"
    modules=$((modules + 1))
done > "$everything"
echo 'int main() {}' >> "$everything"
look "$everything" | sort -u > "$scratch/faults"
cat "$scratch/faults"
# A source that could not be read has no warnings either.
grep 'error:' "$everything.errors" && { echo "it was not read to its end"; exit 1; }
echo "$modules modules, $(wc -l < "$scratch/faults") warnings"
[ "$modules" -gt 7 ] && [ ! -s "$scratch/faults" ]
