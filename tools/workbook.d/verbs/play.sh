# shellcheck shell=bash
# SPDX-License-Identifier: BSL-1.0
#
# your answer as a policy of the real world, in its section's scene, beside the library's
#
#   ./workbook play drag

verb_play() {
    if [ $# -ne 1 ]; then complain "which exercise? ./workbook play <name>"; return 2; fi
    choose_exercise "$1" || return 2
    prepared || return 1
    if ! build_quietly "building the scene" "play.$ID"; then
        first_error_of_answer build/logs/exercise.log "$FOLDER/exercise.hpp" || tail -n 5 build/logs/exercise.log >&2
        say "${DIM}all that the compiler said: build/logs/exercise.log$PLAIN"
        return 1
    fi
    local status log=build/logs/play.log
    mkdir -p "$PICTURES"
    heading "$NUMBER $TITLE"
    { timeout --foreground 120 "$BUILD/exercises/$ID/play" 2> "$log" < /dev/null; } 2> /dev/null
    status=$?
    if [ $status -ne 0 ]; then
        if grep -q 'not done yet' "$log"; then complain "$(sed -n 's/.*\(not done yet: task [0-9]*\).*/\1/p' "$log" | head -n 1); ./workbook exercise ${ID#*.} first"
        else complain "the scene ended with code $status: $(tail -n 1 "$log")"; fi
        return 1
    fi
    sed -n "s|^picture: $ROOT/|picture: |p; /^picture skipped/p" "$log"
}
