# shellcheck shell=bash
# SPDX-License-Identifier: BSL-1.0
#
# your answer beside our solution, once yours passes
#
#   ./workbook diff drag
#   ./workbook diff drag --anyway     although it does not pass yet

verb_diff() {
    local anyway=false word=''
    for argument in "$@"; do
        case $argument in
            --anyway) anyway=true ;;
            *)
                if [ -n "$word" ]; then complain "one exercise at a time; what is '$argument'? ./workbook help diff"; return 2; fi
                word=$argument ;;
        esac
    done
    if [ -z "$word" ]; then complain "of which exercise? ./workbook diff <name>"; return 2; fi
    choose_exercise "$word" || return 2
    files_there exercise.hpp solution.hpp || return 1
    if [ "$(progress_of "$ID")" != done ] && ! $anyway; then
        say "This exercise is not done yet. ./workbook hint ${ID#*.} helps step by step; ./workbook diff ${ID#*.} --anyway shows the solution."
        return 1
    fi
    # The marks of the tasks are for us, not for a reader.
    mkdir -p build/logs
    sed -E '/^ *\/\/ (end of )?task [0-9]+/d' "$FOLDER/solution.hpp" > build/logs/solution.hpp
    if diff -u -w --label "$FOLDER/exercise.hpp (yours)" --label "$FOLDER/solution.hpp (ours)" "$FOLDER/exercise.hpp" build/logs/solution.hpp > build/logs/diff.txt; then
        echo "Your answer is our solution, but for spaces at most."
    else
        sed -e "s/^-.*/$RED&$PLAIN/" -e "s/^+.*/$GREEN&$PLAIN/" build/logs/diff.txt
    fi
}
