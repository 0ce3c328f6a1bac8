#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
#
# Whether clang-tidy finds nothing in the library's headers by the rules of .clang-tidy, and whether it finds a planted
# fault. All headers, by way of the one of each module: it takes less than a minute, and what changed is among them.
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

for header in "$project"/include/ansatz/*.hpp; do
    module=$(basename "$header" .hpp)
    printf '#include <ansatz/%s.hpp>\nint main() {}\n' "$module" > "$scratch/$module.cpp"
    echo "$scratch/$module.cpp"
done > "$scratch/sources"
while read -r source; do
    look "$source" > "$source.faults" &
    [ "$(jobs -r | wc -l)" -lt "$(nproc)" ] || wait -n
done < "$scratch/sources"
wait
sed 's/$/.faults/' "$scratch/sources" | xargs cat | sort -u > "$scratch/faults"
cat "$scratch/faults"
# A source that could not be read has no warnings either.
sed 's/$/.errors/' "$scratch/sources" | xargs grep -l 'error:' && { echo "these were not read to their end"; exit 1; }
modules=$(wc -l < "$scratch/sources")
echo "$modules modules, $(wc -l < "$scratch/faults") warnings"
[ "$modules" -gt 7 ] && [ ! -s "$scratch/faults" ]
