# shellcheck shell=bash
# SPDX-License-Identifier: BSL-1.0
#
# build and test your answer to the next exercise, or to one by name
#
#   ./workbook exercise                   the next one that is not done
#   ./workbook exercise semi_implicit_euler   one by name; its section's number does as well: exercise 1.6.3
#
# You edit exercises/<chapter>/<name>/exercise.hpp. The tests run in order of the tasks, each in a process of its own, and
# the first that does not pass is explained. Where your numbers are those of a well-known mistake, it is named.

# shellcheck source=/dev/null
. "$ROOT/tools/exercises/judge.sh"
CPU_SECONDS=${ANSATZ_CPU_SECONDS:-5}      # somebody waits

verb_exercise() {
    if [ $# -gt 1 ]; then complain "one exercise at a time; ./workbook help exercise"; return 2; fi
    choose_exercise "${1:-}" || return 2
    prepared || return 1
    if [ $# -eq 0 ] && [ "$(progress_of "$ID")" = done ]; then
        say "Every exercise is done. ./workbook exercise <name> takes one again; this is the last:"
    fi
    try_exercise
}

# Builds and tests the answer to the chosen exercise, and says how it is.
try_exercise() {
    local start answer=$FOLDER/exercise.hpp programs=$BUILD/exercises/$ID
    start=$(now)
    heading "$NUMBER $TITLE"
    say "${DIM}the task: $FOLDER/README.md, your answer: $answer$PLAIN"
    echo
    if [ ! -f "$answer" ]; then
        complain "$answer is not there; ./workbook reset ${ID#*.} makes it anew"
        return 1
    fi
    if ! build_quietly "compiling your answer" "exercise.$ID.student"; then
        first_error_of_answer build/logs/exercise.log "$answer" || tail -n 5 build/logs/exercise.log >&2
        say "${DIM}all that the compiler said: build/logs/exercise.log$PLAIN"
        return 1
    fi
    local tests task name sentence
    if ! tests=$(tests_of "$programs/student"); then complain "the tests of $ID cannot be listed: $programs/student"; return 1; fi
    while IFS=$'\t' read -r task name sentence; do
        run_test "$programs/student" "$name"
        if [ "$OUTCOME" = passed ]; then
            printf '  %s✓%s %s\n' "$GREEN" "$PLAIN" "$sentence"
            continue
        fi
        [ "$OUTCOME" = todo ] || record "$ID" started
        not_passed "$task" "$sentence" "$answer" "$(printf '%s\n' "$tests" | cut -f 1 | tail -n 1)"
        echo
        say "${DIM}$(duration $(($(now) - start))); again: ./workbook exercise ${ID#*.}, or ./workbook watch; help: ./workbook hint$PLAIN"
        return 1
    done <<< "$tests"
    record "$ID" done
    rm -f $NOTEBOOK/at
    echo
    say "${GREEN}Done: every test passes.$PLAIN ${DIM}$(duration $(($(now) - start)))$PLAIN"
    say "./workbook play ${ID#*.} puts it into the world beside the library's; ./workbook diff ${ID#*.} shows our solution. ./workbook exercise goes on with the next."
}

# not_passed <task> <sentence> <answer> <tasks>: what run_test has found, for a person.
not_passed() {
    local task=$1 sentence=$2 answer=$3 tasks=$4 line wrong
    mkdir -p $NOTEBOOK && printf '%s\t%s\n' "$ID" "$task" > $NOTEBOOK/at
    printf '  %s✗%s %s\n\n' "$RED" "$PLAIN" "$sentence"
    if [ "$OUTCOME" = todo ]; then
        line=$(grep -n "todo($task)" "$answer" | head -n 1 | cut -d : -f 1)
        say "Task $task is not done yet: it waits at $answer${line:+:$line}."
        return
    fi
    printf '%s\n' "$TEXT" | while IFS= read -r line; do
        case $line in ' '*) printf '  %s\n' "$line" ;; *) say "$line" | sed 's/^/  /' ;; esac
    done
    if [ -n "$PRINTED" ]; then
        printf '\n  your program printed:\n'
        printf '%s\n' "$PRINTED" | head -n 8 | sed 's/^/    /'
    fi
    case $OUTCOME in failed | threw) ;; *) return ;; esac    # only numbers can be compared
    build_quietly "preparing the answers people give (once)" "exercise.$ID.others" || return
    for wrong in $(mistake_of "$FOLDER" "$BUILD/exercises/$ID" student "$tasks"); do
        wrong=$FOLDER/wrong/$wrong.hpp
        echo
        say "${YELLOW}Your numbers equal those of: $(line_of "$wrong" Mistake).$PLAIN" | sed 's/^/  /'
        say "$(line_of "$wrong" Why) See $(line_of "$wrong" Read)." | sed 's/^/  /'
    done
}
