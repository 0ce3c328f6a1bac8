#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
#
# The programs in README.md are tests/package/engine.cpp and pool.cpp, which the tests package.* compile and run.
#
# usage: readme.sh <folder of the project>
set -euo pipefail
project=$1
faults=0
compare() {    # which listing of the page, and the program that it should be, without its licence line
    local listing program
    listing=$(awk -v wanted="$1" '/^```cpp$/ { inside = ++n == wanted; next } /^```$/ { inside = 0 } inside' "$project/README.md")
    program=$(tail -n +2 "$project/tests/package/$2")
    [ "$listing" = "$program" ] && return
    echo "Listing $1 of README.md is not tests/package/$2; copy the latter (without its first line) into the former:"
    diff <(printf '%s\n' "$listing") <(printf '%s\n' "$program") || true
    faults=$((faults + 1))
}
compare 1 engine.cpp
compare 2 pool.cpp
[ "$(grep -c '^```cpp$' "$project/README.md")" -eq 2 ] || { echo "README.md should have two listings in C++"; faults=$((faults + 1)); }
[ $faults -eq 0 ]
