# shellcheck shell=bash
# SPDX-License-Identifier: BSL-1.0
#
# begin an exercise anew; what you wrote is put aside, not lost
#
#   ./workbook reset drag

verb_reset() {
    one_exercise reset 1 "$@" || return 2
    choose_exercise "$1" || return 2
    files_there solution.hpp || return 1
    python_there || return 1
    local answer=$FOLDER/exercise.hpp aside
    if skeleton_of "$FOLDER" | cmp -s - "$answer"; then
        echo "$answer is as it was at the beginning; nothing to do"
        return 0
    fi
    if [ -f "$answer" ]; then
        aside=$NOTEBOOK/attempts/$ID-$(date '+%Y%m%d-%H%M%S').hpp
        while [ -e "$aside" ]; do aside=${aside%.hpp}+.hpp; done
        mkdir -p $NOTEBOOK/attempts && cp "$answer" "$aside" || { complain "your answer could not be put aside, so nothing was changed"; return 1; }
        echo "what you wrote is in $aside"
    fi
    skeleton_of "$FOLDER" > "$answer.part" && mv -f "$answer.part" "$answer" && echo "$answer is a skeleton again" || return 1
    if [ "$(progress_of "$ID")" = done ]; then note progress "$ID" started "$(date '+%Y-%m-%d')"; fi
}
