#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
#
# Whether every C++ file is laid out as .clang-format says, and whether a file that is not is found. Left out are the
# skeletons of the exercises, which are made from formatted solutions and belong to students.
#
# Another version lays out otherwise: it is clang-format 16, of Debian's clang-format-16. To format what you changed:
#   git diff --name-only --diff-filter=d -- '*.hpp' '*.cpp' | xargs clang-format-16 -i
#
#   format.sh <the project's folder>
set -euo pipefail
cd "${1:?the project folder}"
scratch=${ANSATZ_SCRATCH:-$(mktemp -d)}
mkdir -p "$scratch"

format=$(command -v clang-format-16 || true)
if [ -z "$format" ]; then
    echo "skipped: there is no clang-format-16 (on Debian: apt install clang-format-16)"
    exit
fi

faults=0
printf 'int  main( ){return 0 ;}\n' > "$scratch/planted.cpp"
if "$format" --style=file:.clang-format --dry-run -Werror "$scratch/planted.cpp" 2> /dev/null; then
    echo "a file without any layout was not found"
    faults=1
fi

mapfile -t files < <(find include chapters exercises tests tools docs -name '*.[hc]pp' ! -name exercise.hpp | sort)
if ! printf '%s\n' "${files[@]}" | xargs "$format" --style=file --dry-run -Werror > "$scratch/faults" 2>&1; then
    # One line a place, and what is wrong with the first.
    grep 'error:' "$scratch/faults" | cut -d : -f 1 | sort | uniq -c | sort -rn |
        while read -r places file; do echo "$file: $places places; clang-format-16 -i $file"; done
    faults=1
fi
echo "${#files[@]} files"
[ "${#files[@]}" -gt 800 ] && [ "$faults" -eq 0 ]
