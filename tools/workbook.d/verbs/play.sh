# shellcheck shell=bash
# SPDX-License-Identifier: BSL-1.0
#
# your answer in the real world, beside the library's
#
#   ./workbook play drag
#
# It is a policy of a world there, in the scene of its section.

verb_play() {
    one_exercise play 1 "$@" || return 2
    choose_exercise "$1" || return 2
    files_there exercise.hpp play.cpp || return 1
    prepared || return 1
    if ! build_quietly "building the scene" "play.$ID"; then
        explain_failed_build
        return 1
    fi
    local status log=build/logs/play.log seconds=${ANSATZ_PLAY_SECONDS:-120}
    mkdir -p "$PICTURES"
    heading "$NUMBER $TITLE"
    { timeout --foreground -k 1 "$seconds" "$BUILD/exercises/$ID/play" 2> "$log" < /dev/null; } 2> /dev/null
    status=$?
    if [ $status -eq 124 ] || [ $status -eq 137 ]; then
        complain "the scene did not come to an end within $seconds s: is there a loop that never ends?"
        return 1
    elif [ $status -ne 0 ]; then
        if grep -q 'not done yet' "$log"; then complain "$(sed -n 's/.*\(not done yet: task [0-9]*\).*/\1/p' "$log" | head -n 1); ./workbook exercise ${ID#*.} first"
        else complain "the scene ended with code $status: $(tail -n 1 "$log")"; fi
        return 1
    elif ! grep -qx 'the scene is over' "$log"; then
        complain "your answer ended the program (exit) before the scene was over"
        return 1
    fi
    sed -n "s|^picture: $ROOT/|picture: |p; /^picture skipped/p" "$log"
}
