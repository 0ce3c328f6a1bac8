# shellcheck shell=bash
# SPDX-License-Identifier: BSL-1.0
#
# The exercises: which there are, how far the student is, and what a test's answer is called in words.
#
# An exercise is a folder exercises/<n-module>/<name> whose README.md begins with "# <section> <title>". It is known by
# its id, <module>.<name>, which stays when chapters are renumbered. What belongs to the student lies in .workbook/, in
# nobody's repository and in no build folder, so that neither an update nor a clean build takes it away:
#
#   progress    id, "started" or "done", date; the last line about an exercise counts
#   at          id and task of the last test that did not pass
#   hints       id, task, level: the hints that were seen
#   attempts/   what reset has put aside

NOTEBOOK=.workbook

# Every exercise as number, id, title, folder; in the order of the course.
exercise_index() {
    local file folder module
    for file in exercises/*/*/test.cpp; do
        [ -f "$file" ] || continue
        folder=${file%/test.cpp}
        module=${folder#exercises/}
        module=${module%/*}
        awk -v id="${module#*-}.${folder##*/}" -v folder="$folder" '
            NR == 1 && sub(/^# /, "") { number = $1; sub(/^[0-9.]+ +/, ""); title = $0 }
            END { printf "%s\037%s\037%s\037%s\n", number, id, title == "" ? id : title, folder }' \
            "$folder/README.md" 2> /dev/null || printf '%s\037%s\037%s\037%s\n' 0 "${module#*-}.${folder##*/}" "${folder##*/}" "$folder"
    done | sort -t "$SEP" -k 1,1V
}

# choose_exercise [word]: sets NUMBER, ID, TITLE, FOLDER to the exercise of this name, id or section; without a word to the
# first that is not done, or to the last one when all are.
choose_exercise() {
    local word=${1:-} index line
    index=$(exercise_index)
    if [ -z "$index" ]; then complain "there is no exercise in exercises/ yet"; return 2; fi
    if [ -z "$word" ]; then
        line=$(while IFS= read -r line; do
            [ "$(progress_of "$(printf '%s' "$line" | cut -d "$SEP" -f 2)")" = done ] || { printf '%s\n' "$line"; break; }
        done <<< "$index")
        [ -n "$line" ] || line=$(printf '%s\n' "$index" | tail -n 1)
    else
        word=${word%/}
        word=$(printf '%s' "${word##*/}" | tr '[:upper:]- ' '[:lower:]__')
        line=$(printf '%s\n' "$index" | awk -F '\037' -v word="$word" '
            $1 == word || $2 == word || substr($2, index($2, ".") + 1) == word { print; found = 1; exit }
            index($2, word) > 0 { near = $0; count++ }
            END { if (!found && count == 1) print near }')
    fi
    if [ -z "$line" ]; then
        complain "there is no exercise '$word'$(did_you_mean "$word" "$(printf '%s\n' "$index" | cut -d "$SEP" -f 2 | sed 's/^[^.]*\.//')")"
        say "./workbook list shows them all."
        return 2
    fi
    IFS=$SEP read -r NUMBER ID TITLE FOLDER <<< "$line"
}

progress_of() {
    [ -f $NOTEBOOK/progress ] || return 0
    awk -F '\t' -v id="$1" '$1 == id { last = $2 } END { print last }' $NOTEBOOK/progress
}
record() { # <id> <started|done>
    [ "$(progress_of "$1")" = "$2" ] && return 0
    [ "$(progress_of "$1")" = done ] && return 0
    mkdir -p $NOTEBOOK && printf '%s\t%s\t%s\n' "$1" "$2" "$(date '+%Y-%m-%d')" >> $NOTEBOOK/progress
}

skeleton_of() { awk -f tools/exercises/skeleton.awk "$1/solution.hpp"; }

# What one sees of an exercise in a list.
state_of_exercise() {
    local state
    state=$(progress_of "$1")
    if [ -n "$state" ]; then echo "$state"
    elif skeleton_of "$2" | cmp -s - "$2/exercise.hpp"; then echo "open"
    else echo "started"; fi
}

# The first error of a compiler that a student needs: a sentence of the library, or what is wrong in the student's file,
# with the line as it stands there.
first_error_of_answer() {
    local log=$1 file=$2
    awk -v file="$file" -v root="$ROOT/" -f tools/exercises/first_error.awk "$log" > "$log.first" || return 1
    local line where message
    { read -r line; read -r where; IFS= read -r message; } < "$log.first"
    if [ "${line:-0}" -gt 0 ]; then
        complain "it does not compile; the first error is at $file:$line"
        printf '%5d | %s\n' "$line" "$(sed -n "${line}p" "$file")" >&2
    else
        complain "it does not compile; the first error is at $where"
    fi
    printf '%s\n' "$message" | fold -s -w "$((WIDTH > 60 ? WIDTH - 4 : 56))" | sed 's/^/    /; s/ *$//' >&2
    case $where in */test.cpp:*) say "    The test asks for this; it must stand, under this name, in namespace exercise of $file." >&2 ;; esac
}

# Builds targets of an exercise without a word about what is done already. Once the answer has been built, without ccache:
# it would only be in the way of one small file.
build_quietly() { # <what> <targets...>
    local what=$1 log=build/logs/exercise.log target targets=() start
    shift
    for target in "$@"; do targets+=(--target "$target"); done
    mkdir -p build/logs
    start=$(now)
    [ -x "$BUILD/exercises/$ID/student" ] && local -x CCACHE_DISABLE=1
    cmake --build "$BUILD" -j "$(jobs_here)" "${targets[@]}" < /dev/null 2>&1 | tee "$log" | build_progress "$what" "$start"
    local status=${PIPESTATUS[0]}
    clear_progress
    return "$status"
}

# A machine that was made ready once is not asked again each time.
prepared() {
    local home
    home=$(sed -n "s/^CMAKE_HOME_DIRECTORY:INTERNAL=//p" "$BUILD/CMakeCache.txt" 2>/dev/null)
    if [ "$home" = "$ROOT" ] && { [ -f "$BUILD/build.ninja" ] || [ -f "$BUILD/Makefile" ]; } && [ -d "$BUILD/exercises" ]; then return 0; fi
    provide && configure
}
