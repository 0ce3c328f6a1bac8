#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
#
# What the chapters say that a program prints is what it prints: docs/recordings/<number>.txt, byte for byte.
#
# usage: recordings.sh <folder of the project>
#
# The programs are those of the build that ANSATZ_SCRATCH belongs to. Another compiler or other options may differ in the
# last digit; then this says where. tools/docs/record records anew.
#
# The same of their films (tools/film.hpp): each that a section draws is kept in docs/pictures and is, frame by frame, what is drawn.
set -euo pipefail
project=$1
build=${ANSATZ_BUILD:-${ANSATZ_SCRATCH%/*/*}}
rm -rf "$ANSATZ_SCRATCH/pictures"
mkdir -p "$ANSATZ_SCRATCH/pictures"
cd "$project"
# shellcheck source=/dev/null
. tools/workbook.d/lib/section_program.sh
shopt -s nullglob
faults=0
fault() { printf 'recordings: %s\n' "$*"; faults=$((faults + 1)); }

programs=(chapters/*/[0-9]*-*.cpp)
if [ ${#programs[@]} -eq 0 ]; then echo "recordings: there is no section in chapters/"; exit 1; fi
pages=(docs/*.md exercises/*/*/README.md)
# What the pages quote.
included=$(cat "${pages[@]}" | grep -oE '^<!-- output: [^ ]+' | awk '{ print $NF }' || true)

# differs <kept film> <drawn film>: says which frames do, and whether there are more or fewer than before.
differs() {
    awk '
        !/<g id="f[0-9]+"/ { rest[FILENAME] = rest[FILENAME] "\n" $0; next }
        { frame = $0; sub(/.*<g id="f/, "", frame); sub(/".*/, "", frame) }
        FILENAME == ARGV[1] { kept[frame] = $0; was++; next }
        { now++; if (!(frame in kept) || kept[frame] != $0) { if (!wrong++) first = frame; last = frame } }
        END {
            if (was != now) printf "%d frames are kept, and %d are drawn; ", was, now
            if (wrong) printf "%d frames differ, from %d to %d", wrong, first, last
            else if (rest[ARGV[1]] != rest[ARGV[2]]) printf "its frames are the same, and its head or its scenery differs"
            else printf "its frames differ in number alone"
        }' "$1" "$2"
}
films=0
compared=0
for source in "${programs[@]}"; do
    name=${source##*/}
    number=${name%%-*}
    recording=docs/recordings/$number.txt
    if [ ! -f "$recording" ]; then fault "section $number has no recording; tools/docs/record $number makes it"; continue; fi
    program=$(section_program "$build" "$source")
    if [ -z "$program" ]; then fault "section $number is not built: there is no section_$number in $build/chapters"; continue; fi
    if ! ANSATZ_PICTURES=$ANSATZ_SCRATCH/pictures "$program" "$number" > "$ANSATZ_SCRATCH/$number.txt" 2> "$ANSATZ_SCRATCH/$number.log" < /dev/null; then
        fault "section $number failed: $(tail -n 1 "$ANSATZ_SCRATCH/$number.log")"
        continue
    fi
    compared=$((compared + 1))
    if ! cmp -s "$recording" "$ANSATZ_SCRATCH/$number.txt"; then
        fault "section $number prints something else than $recording; recorded (-) and printed now (+):"
        if [ "$source" -nt "$program" ]; then echo "(the program is older than its source: build it first)"; fi
        diff -U 0 "$recording" "$ANSATZ_SCRATCH/$number.txt" | sed -n '/^@@/d; 3,$p' || true
    fi
    for film in "$ANSATZ_SCRATCH/pictures/$number"-*film.svg "$ANSATZ_SCRATCH/pictures/$number"-*sheet.svg; do
        kept=docs/pictures/${film##*/}
        films=$((films + 1))
        if [ ! -f "$kept" ]; then fault "$kept is not kept; tools/docs/record $number keeps it"
        elif ! cmp -s "$kept" "$film"; then fault "$kept is not what section $number draws: $(differs "$kept" "$film")"
        fi
    done
    for kept in docs/pictures/"$number"-*film.svg docs/pictures/"$number"-*sheet.svg; do
        [ -f "$ANSATZ_SCRATCH/pictures/${kept##*/}" ] || fault "$kept is kept, and section $number draws no such film"
    done
done
for recording in docs/recordings/*; do
    name=${recording##*/}
    sources=(chapters/*/"${name%.txt}"-*.cpp)
    if [ ${#sources[@]} -eq 0 ]; then fault "$recording is no section's"; continue; fi
    grep -qE "(^|/)${name//./\\.}\$" <<< "$included" || fault "no page includes $recording"
done

if [ "$faults" -gt 0 ]; then
    echo "recordings: $faults faults. Where the programs are right and the recordings old: tools/docs/record, then read git diff docs/recordings and look at the films"
    exit 1
fi
echo "$compared recordings are what the sections print, and $films films and contact sheets what they draw"
