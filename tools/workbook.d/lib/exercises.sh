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

# Every exercise as number, id, title, folder; in the order of the course. One whose test is gone is one all the same.
exercise_index() {
    local folder module
    for folder in exercises/*-*/*/; do
        folder=${folder%/}
        [ -f "$folder/test.cpp" ] || [ -f "$folder/solution.hpp" ] || continue
        module=${folder#exercises/}
        module=${module%/*}
        # Without its README.md it has no number and no title.
        head -n 1 "$folder/README.md" 2> /dev/null | awk -v id="${module#*-}.${folder##*/}" -v folder="$folder" '
            NR == 1 && sub(/^# /, "") { number = $1; sub(/^[0-9.]+ +/, ""); title = $0 }
            END { printf "%s\037%s\037%s\037%s\n", (number == "" ? 0 : number), id, (title == "" ? id : title), folder }'
    done | sort -t "$SEP" -k 1,1V
}

# The exercise's name, section or id in what a person gave, which may be the path of one of its files.
word_of() {
    local word=${1%/}
    case $word in */*.hpp | */*.cpp | */*.md | */*.diff) word=${word%/*} ;; esac
    printf '%s' "${word##*/}" | tr '[:upper:]- ' '[:lower:]__'
}

# Those exercises of an index that a word names: exactly, or else by a part of the name or by a section above it.
named() { # <index> <word>
    printf '%s\n' "$1" | awk -F '\037' -v word="$2" '
        ($1 "") == word || $2 == word || substr($2, index($2, ".") + 1) == word { exact = exact $0 "\n" }
        index($2, word) > 0 || index($1, word ".") == 1 { near = near $0 "\n" }
        END { printf "%s", (exact != "" ? exact : near) }'
}

# choose_exercise [word]: sets NUMBER, ID, TITLE, FOLDER to the exercise of this name, id, section or file; without a word
# to the first that is not done, or to the last one when all are.
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
        word=$(word_of "$word")
        line=$(named "$index" "$word")
    fi
    if [ -z "$line" ]; then
        complain "there is no exercise '$word'$(did_you_mean "$word" "$(printf '%s\n' "$index" | cut -d "$SEP" -f 2 | sed 's/^[^.]*\.//')")"
        say "./workbook list shows them all."
        return 2
    fi
    if [ "$(printf '%s\n' "$line" | grep -c .)" -gt 1 ]; then
        complain "'$word' may be any of these exercises; give one name:"
        printf '%s\n' "$line" | awk -F '\037' '{ sub(/^[^.]*\./, "", $2); print "  " $1 " " $2 }'
        return 2
    fi
    IFS=$SEP read -r NUMBER ID TITLE FOLDER <<< "$line"
}

# one_exercise <verb> <how many at least> <words...>: whether they are as many names as the verb takes.
one_exercise() {
    local verb=$1 least=$2
    shift 2
    if [ $# -lt "$least" ]; then complain "which exercise? ./workbook $verb <name>"; return 2; fi
    if [ $# -gt 1 ]; then complain "one exercise at a time; what is '$2'? ./workbook help $verb"; return 2; fi
}

# files_there <names...>: whether the chosen exercise has these files; a sentence for the first that it has not.
files_there() {
    local name
    for name in "$@"; do
        [ -f "$FOLDER/$name" ] && continue
        if [ "$name" = exercise.hpp ]; then complain "$FOLDER/$name is not there; ./workbook reset ${ID#*.} makes it anew"
        else complain "$FOLDER/$name is not there; git checkout $FOLDER/$name brings it back"; fi
        return 1
    done
}

progress_of() {
    [ -f $NOTEBOOK/progress ] || return 0
    awk -F '\t' -v id="$1" '$1 == id { last = $2 } END { print last }' $NOTEBOOK/progress
}
# note <file> <fields...>: a line in the notebook; fails, with a sentence, where it could not be written.
note() {
    local file=$NOTEBOOK/$1 line
    shift
    line=$(printf '%s\t' "$@")
    if ! { mkdir -p $NOTEBOOK && printf '%s\n' "${line%?}" >> "$file"; } 2> /dev/null; then
        complain "$file could not be written: is the disk full, or is the folder somebody else's?"
        return 1
    fi
}
record() { # <id> <started|done>: what is done stays done, until it is reset
    [ "$(progress_of "$1")" = "$2" ] && return 0
    [ "$(progress_of "$1")" = done ] && return 0
    note progress "$1" "$2" "$(date '+%Y-%m-%d')"
}

# python_there: what reads and writes the files of an exercise is written in Python.
python_there() {
    command -v python3 > /dev/null && return 0
    complain "Python 3 is not there (on Debian: apt install python3)"
    return 1
}

skeleton_of() { python3 tools/workshop/skeleton.py "$1/solution.hpp"; }

# find_untouched: UNTOUCHED are the folders of the exercises that nobody has begun, asked once for all of them. Without
# Python no answer could be tested yet, and each is taken for such a one.
find_untouched() {
    UNTOUCHED=$(if command -v python3 > /dev/null; then python3 tools/workshop/skeleton.py --untouched exercises/*-*/*
        else printf '%s\n' exercises/*-*/*; fi)
}

# What one sees of an exercise in a list, after find_untouched.
state_of_exercise() {
    local state
    state=$(progress_of "$1")
    if [ -n "$state" ]; then echo "$state"
    elif [ ! -f "$2/exercise.hpp" ] || [ ! -f "$2/solution.hpp" ]; then echo "missing"
    elif grep -qxF -e "$2" <<< "$UNTOUCHED"; then echo "open"
    else echo "started"; fi
}

# The first error of a compiler that a student needs: a sentence of the library, or what is wrong in the student's file,
# with the line as it stands there.
first_error_of_answer() {
    local log=$1 file=$2
    python3 tools/workshop/first_error.py --file "$file" --root "$ROOT/" "$log" > "$log.first" || return 1
    local line where message
    { read -r line; read -r where; IFS= read -r message; } < "$log.first"
    if [ "${line:-0}" -gt 0 ]; then
        complain "it does not compile; the first error is at $file:$line"
        printf '%5d | %s\n' "$line" "$(sed -n "${line}p" "$file")" >&2
    else
        case $where in
            linking) complain "it compiles, but it makes no program" ;;
            disk) complain "it could not be compiled" ;;
            end) complain "it does not compile; the first error is at the end of $file" ;;
            *) complain "it does not compile; the first error is at $where" ;;
        esac
    fi
    printf '%s\n' "$message" | fold -s -w "$((WIDTH > 60 ? WIDTH - 4 : 56))" | sed 's/^/    /; s/ *$//' >&2
    case $where in */test.cpp:*) say "    The test asks for this; it must stand, under this name, in namespace exercise of $file." >&2 ;; esac
}

# What to do with a build of the chosen exercise that failed.
explain_failed_build() {
    first_error_of_answer build/logs/exercise.log "$FOLDER/exercise.hpp" || {
        complain "it could not be built; the last that was said:"
        tail -n 5 build/logs/exercise.log | sed "s|$ROOT/||g" >&2
    }
    say "${DIM}all that the compiler said: build/logs/exercise.log$PLAIN"
}

# Builds targets of an exercise without a word about what is done already. Once the answer has been built, without ccache:
# it would only be in the way of one small file.
build_quietly() { # <what> <targets...>
    local what=$1 log=build/logs/exercise.log target targets=() start
    shift
    for target in "$@"; do targets+=(--target "$target"); done
    mkdir -p build/logs
    take_turns
    start=$(now)
    [ -x "$BUILD/exercises/$ID/student" ] && local -x CCACHE_DISABLE=1
    cmake --build "$BUILD" -j "$(jobs_here)" "${targets[@]}" < /dev/null 8>&- 2>&1 | tee "$log" | build_progress "$what" "$start"
    local status=${PIPESTATUS[0]}
    end_turn
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
