# shellcheck shell=bash
# SPDX-License-Identifier: BSL-1.0
#
# check the exercises themselves: every answer against every test
#
#   ./workbook verify             all of them
#   ./workbook verify drag        one
#
# The library and the solution must pass, the skeleton must fail each task as "not done yet", each wrong answer must fail
# exactly the tests that it lists and be named as the mistake it is, and no test may catch nothing.

verb_verify() {
    local index chosen number id title folder failed=0 count=0 targets=()
    index=$(exercise_index)
    one_exercise verify 0 "$@" || return 2
    if [ $# -gt 0 ]; then
        choose_exercise "$1" || return 2
        index="$NUMBER$SEP$ID$SEP$TITLE$SEP$FOLDER"
    fi
    if [ -z "$index" ]; then complain "there is no exercise in exercises/ yet"; return 2; fi
    while IFS=$SEP read -r _ ID _ FOLDER; do
        files_there README.md exercise.hpp library.hpp solution.hpp wrong.diff test.cpp hints.md play.cpp || return 1
    done <<< "$index"
    prepared || return 1
    while IFS=$SEP read -r number id title folder; do targets+=("exercise.$id.others"); done <<< "$index"
    build "every answer" "${targets[@]}" || return 1
    while IFS=$SEP read -r number id title folder; do
        count=$((count + 1))
        take_turns     # nobody may build these programs anew while they are judged
        if chosen=$(bash tools/exercises/judge.sh verify "$folder" "$BUILD/exercises/$id" 8>&-); then
            printf '%s\n\n' "$chosen"
        else
            failed=$((failed + 1))
            printf '%s\n\n' "$chosen" | sed "s/^  *[0-9]* faults in .*/$RED&$PLAIN/"
        fi
        end_turn
    done <<< "$index"
    if [ "$failed" -gt 0 ]; then complain "$failed of $count exercises do not keep their promises"; return 1; fi
    echo "$count exercises verified"
}
