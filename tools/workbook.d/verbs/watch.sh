# shellcheck shell=bash
# SPDX-License-Identifier: BSL-1.0
#
# test your answer again whenever you save it
#
#   ./workbook watch              the next exercise that is not done
#   ./workbook watch drag         one by name
#
# Without a name it goes on to the next exercise when one is done. Ctrl-C ends it.

# shellcheck source=/dev/null
. "$ROOT/tools/workbook.d/verbs/exercise.sh"

saved_at() { stat -c '%Y.%y' "$1" 2> /dev/null || stat -f '%m' "$1" 2> /dev/null; }

verb_watch() {
    one_exercise watch 0 "$@" || return 2
    local seen=''
    choose_exercise "${1:-}" || return 2
    files_there exercise.hpp test.cpp || return 1
    prepared || return 1
    while :; do
        if [ "$(saved_at "$FOLDER/exercise.hpp")" != "$seen" ]; then
            seen=$(saved_at "$FOLDER/exercise.hpp")
            $LIVE && printf '\033[H\033[2J'
            if try_exercise && [ $# -eq 0 ]; then
                local before=$ID
                choose_exercise || return 2
                if [ "$(progress_of "$ID")" = done ]; then say "Every exercise is done."; return 0; fi
                [ "$ID" != "$before" ] && { seen=''; echo; continue; }
            fi
            echo
            say "${DIM}watching $FOLDER/exercise.hpp; Ctrl-C ends$PLAIN"
        fi
        [ "${ANSATZ_WATCH_ONCE:-}" = true ] && return 0
        sleep 0.2
    done
}
