# shellcheck shell=bash
# SPDX-License-Identifier: BSL-1.0
#
# The sections of the course: what there is, what state it is in, and running one.
#
# A section is a program chapters/<n>-<module>/<number>-<subject>.cpp whose comment after the licence line says
#     // 1.6.1 Explicit Euler: every step adds energy
# (without it, the subject in its name is its title). Its target is section_1.6.1, its output goes to
# build/sections/1.6.1.txt, its pictures are 1.6.1.svg or 1.6.1-<what>.svg in build/pictures.

SECTIONS=build/sections
PICTURES=build/pictures
export ANSATZ_PICTURES=$ROOT/$PICTURES
SEP=$'\037'          # between fields: a tab would let empty fields collapse in `read`

# Every section as number, title, claim, file; in the order of the numbers.
section_index() {
    local file name
    for file in chapters/*/[0-9]*-*.cpp; do
        [ -f "$file" ] || continue
        name=${file##*/}
        name=${name%.cpp}
        awk -v file="$file" -v number="${name%%-*}" -v title="${name#*-}" '
            FNR > 8 { exit }
            index($0, "// " number " ") == 1 {
                title = substr($0, length(number) + 5)
                if ((colon = index(title, ": ")) > 0) { claim = substr(title, colon + 2); title = substr(title, 1, colon - 1) }
                found = 1
                exit
            }
            END {
                if (!found) { gsub(/_/, " ", title); title = toupper(substr(title, 1, 1)) substr(title, 2) }
                printf "%s\037%s\037%s\037%s\n", number, title, claim, file
            }' "$file"
    done | sort -t "$SEP" -k 1,1V
}

# The index again, only the numbers; and only what lies at or below a number.
numbers() { printf '%s\n' "$1" | cut -d "$SEP" -f 1; }
at_or_below() {
    printf '%s\n' "$1" | awk -F '\037' -v number="$2" '$1 "" == number "" || index($1, number ".") == 1'
}

# "Soft bodies" for chapters/4-soft_bodies/...
chapter_title() {
    local folder=${1#chapters/}
    folder=${folder%%/*}
    folder=${folder#*-}
    folder=${folder//_/ }
    printf '%s' "$(printf '%s' "${folder:0:1}" | tr '[:lower:]' '[:upper:]')${folder:1}"
}

# The pictures and films of a section, one a line; without the contact sheets, which are for print.
pictures_of() {
    local file
    for file in "$PICTURES/$1.svg" "$PICTURES/$1"-*.svg; do
        case $file in *-sheet.svg) continue ;; esac
        [ -f "$file" ] && echo "$file"
    done
    return 0
}

# What a section has come to: "not built", "built", "run", "changed since" (its source is newer).
state_of() {
    local number=$1 file=$2 output=$SECTIONS/$1.txt
    if [ -f "$output" ]; then
        if [ "$file" -nt "$output" ]; then echo "changed"; else echo "run"; fi
    elif [ -n "$(section_program "$BUILD" "$file")" ]; then echo "built"
    else echo "not built"; fi
}

# run_section <number> <its source>: its output appears whole in build/sections or not at all. What it says on the
# error stream goes to the log; where it stood still, `timeout` ends it.
run_section() {
    local number=$1 source=$2 program status
    local output=$SECTIONS/$number.txt log=build/logs/section-$number.log
    mkdir -p "$SECTIONS" "$PICTURES" build/logs
    program=$(section_program "$BUILD" "$source")
    if [ -z "$program" ]; then
        echo "the program section_$number was not built" > "$log"
        return 1
    fi
    if [ "$source" -nt "$program" ]; then
        echo "section_$number is older than $source: its build failed" > "$log"
        return 1
    fi
    # The outer redirection catches the shell's own remark on a program that crashes.
    { timeout --foreground 300 "$program" "$number" > "$output.part" 2> "$log" < /dev/null; } 2> /dev/null
    status=$?
    if [ $status -eq 0 ]; then
        mv -f "$output.part" "$output"
        return 0
    fi
    case $status in
        124) echo "-- it ran for 300 s and was ended" >> "$log" ;;
        13[0-9] | 14[0-9]) echo "-- it was ended by signal $((status - 128))" >> "$log" ;;
        *) echo "-- it ended with code $status" >> "$log" ;;
    esac
    # What it managed to print helps to find out why; an output of an earlier run would be a lie now.
    { echo "-- its output up to there:"; cat "$output.part"; } >> "$log"
    rm -f "$output.part" "$output"
    return "$status"
}
