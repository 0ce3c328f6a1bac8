# shellcheck shell=bash
# SPDX-License-Identifier: BSL-1.0
#
# a hint for the task that you are at
#
#   ./workbook hint               the next hint for the last test that did not pass
#   ./workbook hint drag          the same for an exercise by name
#   ./workbook hint drag 2 4      task 2, level 4
#
# Each level says more: first a question, then a place, a shape, the key line.

hint_text() { # <file> <task> <level>: the level's heading and text
    awk -v task="## Task $2: " -v level="$3" '
        index($0, task) == 1 { n++; on = n == level; if (on) { print substr($0, 4); next } }
        /^## / { on = 0 }
        on && /^ *$/ { if (text != "") print text "\n"; text = ""; next }
        on { text = text == "" ? $0 : text " " $0 }
        END { if (text != "") print text }' "$1"
}

# last_hint <id> <task>: the highest level that was seen. Somebody may have written into the notebook: what is no level
# does not count.
last_hint() {
    awk -F '\t' -v id="$1" -v task="$2" '
        $1 == id && $2 == task && $3 ~ /^[0-9][0-9]?$/ && $3 + 0 > last { last = $3 + 0 }
        END { print last + 0 }' $NOTEBOOK/hints 2> /dev/null || echo 0
}

verb_hint() {
    if [ $# -gt 3 ]; then complain "hint takes an exercise, a task and a level; what is '$4'?"; return 2; fi
    local task=${2:-} level=${3:-} at
    at=$(cat $NOTEBOOK/at 2> /dev/null)
    if [ $# -eq 0 ] && [ -n "$at" ]; then choose_exercise "${at%%	*}" || return 2; else choose_exercise "${1:-}" || return 2; fi
    files_there hints.md || return 1
    local file=$FOLDER/hints.md
    # Done is what passed when it was last tested: what fails since has a place in the notebook.
    if [ -z "$task" ] && [ "$(progress_of "$ID")" = done ] && [ "${at%%	*}" != "$ID" ]; then
        say "This exercise is done, so nothing is left to hint at. ./workbook hint ${ID#*.} 1 1 shows the first hint all the same; ./workbook diff ${ID#*.} our solution."
        return 0
    fi
    [ -z "$task" ] && [ "${at%%	*}" = "$ID" ] && task=${at##*	}
    [ -z "$task" ] && task=1
    case $task$level in *[!0-9]*) complain "a task and a level are numbers: ./workbook hint ${ID#*.} 1 2"; return 2 ;; esac
    if [ ${#task} -gt 2 ] || [ ${#level} -gt 2 ]; then complain "there are not so many: a task and a level have two digits at most"; return 2; fi
    task=$((10#$task))
    if ! grep -q "^## Task $task: " "$file"; then complain "$ID has no task $task"; return 2; fi
    if [ -z "$level" ]; then
        level=$(($(last_hint "$ID" "$task") + 1))
    fi
    level=$((10#$level))
    local levels
    levels=$(grep -c "^## Task $task: " "$file")
    [ "$level" -gt "$levels" ] && level=$levels
    [ "$level" -lt 1 ] && level=1
    heading "$NUMBER $TITLE, hint $level of $levels"
    hint_text "$file" "$task" "$level" | while IFS= read -r line; do say "$line"; done
    note hints "$ID" "$task" "$level" || return 1
    echo
    if [ "$level" -lt "$levels" ]; then say "${DIM}./workbook hint says more.$PLAIN"
    else say "${DIM}That was the last hint; ./workbook diff ${ID#*.} --anyway shows the solution.$PLAIN"; fi
}
