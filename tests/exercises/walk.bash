# shellcheck shell=bash
# SPDX-License-Identifier: BSL-1.0
#
# What the walks of a student have in common (student.sh, answers.sh, which source this file): a copy of the project with
# one exercise and a build of its own, and what `./workbook` must say in it.
#
#   . walk.bash <the project's folder>

project=${1:?the project folder}
scratch=${ANSATZ_SCRATCH:?a folder for this test}
tree=$scratch/a\ copy
rm -rf "$scratch" && mkdir -p "$tree/exercises/1-motion" || exit 1
cp -R "$project"/{CMakeLists.txt,CMakePresets.json,README.md,workbook,cmake,include,chapters,tools} "$tree/" || exit 1
cp "$project"/exercises/{CMakeLists.txt,precompiled.cpp} "$tree/exercises/" && cp -R "$project/exercises/1-motion/explicit_euler" "$tree/exercises/1-motion/" || exit 1
cp "$project/exercises/.clang-format" "$tree/exercises/" 2> /dev/null
exercise=$tree/exercises/1-motion/explicit_euler
python3 "$project/tools/workshop/skeleton.py" "$exercise/solution.hpp" > "$exercise/exercise.hpp" || exit 1

passed=0
failed=0
unset COLUMNS NO_COLOR CI
export ANSATZ_CPU_SECONDS=1
# expect <code> <text...> -- <arguments>: every text must be there.
expect() {
    local code=$1 output status texts=() text
    shift
    while [ "$1" != -- ]; do texts+=("$1"); shift; done
    shift
    output=$(cd / && COLUMNS=200 "$tree/workbook" "$@" 2>&1 < /dev/null)
    status=$?
    output=$(printf '%s' "$output" | tr '\n' ' ' | tr -s ' ')
    for text in "${texts[@]}"; do
        case $output in
            *"$text"*) [ $status -eq "$code" ] && { passed=$((passed + 1)); continue; } ;;
        esac
        failed=$((failed + 1))
        printf 'FAILED: workbook %s: expected code %s and "%s", got code %s and:\n    %s\n' "$*" "$code" "$text" "$status" "$output"
    done
}
answer() { sed "s|todo(1);|$1|" "$scratch/skeleton" > "$exercise/exercise.hpp"; }
cp "$exercise/exercise.hpp" "$scratch/skeleton"

