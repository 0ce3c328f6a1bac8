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
    one_exercise exercise 0 "$@" || return 2
    choose_exercise "${1:-}" || return 2
    files_there exercise.hpp test.cpp || return 1
    prepared || return 1
    if [ $# -eq 0 ] && [ "$(progress_of "$ID")" = done ]; then
        say "Every exercise is done. ./workbook exercise <name> takes one again; this is the last:"
    fi
    try_exercise
}

# Builds and tests the answer to the chosen exercise, and says how it is.
try_exercise() {
    local start programs=$BUILD/exercises/$ID first=false
    heading "$NUMBER $TITLE"
    files_there exercise.hpp test.cpp || return 1
    [ -x "$programs/student" ] || first=true
    start=$(now)
    if ! build_quietly "compiling your answer" "exercise.$ID.student"; then
        explain_failed_build
        next_steps
        return 1
    fi
    if ! list_tests "$programs" student; then
        complain "your answer cannot be tested: $TEXT"
        what_it_printed
        next_steps
        return 1
    fi
    local tests=$LISTED task name sentence
    while IFS=$'\t' read -r task name sentence; do
        run_test "$programs" student "$name"
        if [ "$OUTCOME" != passed ]; then
            not_passed "$task" "$sentence"
            time_it_took "$start" $first
            name_the_mistake "$(printf '%s\n' "$tests" | cut -f 1 | tail -n 1)"
            next_steps
            return 1
        fi
        printf '  %s✓%s %s\n' "$GREEN" "$PLAIN" "$sentence"
    done <<< "$tests"
    time_it_took "$start" $first
    record "$ID" done || return 1
    rm -f $NOTEBOOK/at
    echo
    echo "${GREEN}Done: every test passes.$PLAIN"
    next play "puts it into the world beside the library's"
    next diff "shows our solution"
    echo "  ./workbook exercise  goes on with the next"
}

# A line of what may be done next with the chosen exercise.
next() { printf '  %s  %s\n' "$(fit "./workbook $1 ${ID#*.}" $((20 + ${#ID})))" "$2"; }
next_steps() {
    echo
    echo "  task   $FOLDER/README.md"
    echo "  yours  $FOLDER/exercise.hpp"
    echo "  next   ./workbook exercise ${ID#*.}, or ./workbook watch; ./workbook hint ${ID#*.} helps"
}

# time_it_took <start> <first>: from the call to the verdict; `doctor` shows it.
time_it_took() {
    local took=$(($(now) - $1))
    if $2; then remember "first verdict" "$took"; else remember "save to verdict" "$took"; fi
    printf '  %s%s%s\n' "$DIM" "$(duration "$took")" "$PLAIN"
}

what_it_printed() {
    [ -n "$PRINTED" ] || return 0
    printf '\n  your program printed:\n'
    printf '%s\n' "$PRINTED" | head -n 8 | cut -c "1-$WIDTH" | sed 's/^/    /'
}

# not_passed <task> <sentence>: what run_test has found, for a person.
not_passed() {
    local task=$1 sentence=$2 line
    [ "$OUTCOME" = todo ] && task=${TEXT##*task }
    note_place "$task"
    [ "$OUTCOME" = todo ] || record "$ID" started
    printf '  %s✗%s %s\n\n' "$RED" "$PLAIN" "$sentence"
    if [ "$OUTCOME" = todo ]; then
        line=$(grep -n "todo($task)" "$FOLDER/exercise.hpp" | head -n 1 | cut -d : -f 1)
        echo "  Task $task is not done yet: it waits at $FOLDER/exercise.hpp${line:+:$line}."
        return
    fi
    printf '%s\n' "$TEXT" | not_a_number | while IFS= read -r line; do
        case $line in ' '*) printf '  %s\n' "$line" ;; *) say "$line" | sed 's/^/  /' ;; esac
    done
    what_it_printed
}

# "-nan m" is what a machine prints; a person reads what it means.
not_a_number() { sed -E '/^    /s/(^|[ (,])[-+]?nan(\([^)]*\))?/\1not a number/g'; }

# Where `hint` goes on.
note_place() {
    { mkdir -p $NOTEBOOK && printf '%s\t%s\n' "$ID" "$1" > $NOTEBOOK/at; } 2> /dev/null
}

# name_the_mistake <tasks>: after the verdict, for the answers that people give may have to be compiled first. Then it is
# said what for, and how long it took: somebody waits.
name_the_mistake() {
    local tasks=$1 wrong start ANNOUNCE
    case $OUTCOME in failed | threw) ;; *) return ;; esac    # only numbers can be compared
    files_there solution.hpp wrong.diff 2> /dev/null || return
    start=$(now)
    # shellcheck disable=SC2034  # build_progress reads it
    ANNOUNCE="The $(wrong_answers "$FOLDER" | grep -c .) answers that people give are compiled now, once$(time_for "known mistakes"); yours may be among them."
    build_quietly "compiling the answers that people give" "exercise.$ID.others" || return
    if [ -f build/logs/announced ]; then
        remember "known mistakes" $(($(now) - start))
        echo "  ${DIM}They are ready after $(duration $(($(now) - start))).$PLAIN"
    fi
    mistake_of "$FOLDER" "$BUILD/exercises/$ID" student "$tasks"
    [ -z "$MISTAKES" ] || read_heads "$FOLDER"
    for wrong in $MISTAKES; do
        echo
        say "${YELLOW}Your numbers equal those of: $(line_of "$FOLDER" "$wrong" Mistake).$PLAIN" | sed 's/^/  /'
        say "$(line_of "$FOLDER" "$wrong" Why) See $(line_of "$FOLDER" "$wrong" Read)." | sed 's/^/  /'
    done
}
# ", about 12 s", where it was measured once.
time_for() {
    local took
    if took=$(last_duration "$1"); then echo ", about $(duration "$took")"; fi
}
