#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
#
# Whether each exercise.hpp is the skeleton of its solution, letter by letter. A student's answer is no fault: what was
# worked on, in this folder or since the last commit, is left out and named.
#
#   skeletons.sh <the project's folder>
set -u
cd "${1:?the project folder}" || exit 1
faults=0
count=0
untouched=$(python3 tools/workshop/skeleton.py --untouched exercises/*/*) || exit 1
for solution in exercises/*/*/solution.hpp; do
    exercise=${solution%/solution.hpp}/exercise.hpp
    count=$((count + 1))
    grep -qxF "${solution%/*}" <<< "$untouched" && continue
    if [ -d .workbook ] || { git rev-parse --git-dir > /dev/null 2>&1 && ! git diff --quiet HEAD -- "$exercise"; }; then
        echo "$exercise was worked on; left out"
        continue
    fi
    faults=$((faults + 1))
    echo "$exercise is not the skeleton of $solution: python3 tools/workshop/skeleton.py $solution > $exercise"
done
echo "$count exercises, $faults faults"
[ "$count" -gt 0 ] && [ "$faults" -eq 0 ]
