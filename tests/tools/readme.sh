#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
#
# The program in README.md is tests/package/engine.cpp, which the tests package.* compile and run.
#
# usage: readme.sh <folder of the project>
set -euo pipefail
project=$1
listing=$(awk '/^```cpp$/ { inside = 1; next } /^```$/ { inside = 0 } inside' "$project/README.md")
program=$(tail -n +2 "$project/tests/package/engine.cpp")    # without its licence line
if [ "$listing" != "$program" ]; then
    echo "The program in README.md is not tests/package/engine.cpp; copy the latter (without its first line) into the former:"
    diff <(printf '%s\n' "$listing") <(printf '%s\n' "$program") || true
    exit 1
fi
