#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
#
# What compares pages with programs must see a difference. In a small project of one section, whose program is a script, faults are
# planted one by one: tests/tools/recordings.sh must refuse each for its own reason (what is printed, a film, a sheet, a recording of
# nobody), and tests/tools/readme.sh a listing of the README that is not the program. Faults of the site are planted by
# tests/tools/docs.sh, those of the texts by tests/tools/workshop/test_*.py.
#
#   planted_pages.sh <the project's folder>     with ANSATZ_SCRATCH in the environment, as ctest sets it
set -euo pipefail
export LC_ALL=C
project=$(cd "$1" && pwd)
mkdir -p "$ANSATZ_SCRATCH"
tree=$ANSATZ_SCRATCH/tree build=$ANSATZ_SCRATCH/build
passed=0

plant() { # a project in which all is well
    rm -rf "$tree" "$build"
    mkdir -p "$tree/chapters/1-motion" "$tree/docs/recordings" "$tree/docs/pictures" "$tree/exercises" "$tree/tools/workbook.d" \
        "$tree/tests/package" "$build/chapters"
    cp -R "$project/tools/workbook.d/lib" "$tree/tools/workbook.d/"
    cp "$project/README.md" "$tree/"
    cp "$project"/tests/package/*.cpp "$tree/tests/package/"
    echo '// 1.7 Drag' > "$tree/chapters/1-motion/1.7-drag.cpp"
    echo 'It falls.' > "$tree/docs/recordings/1.7.txt"
    # shellcheck disable=SC2016
    printf '<!-- output: docs/recordings/1.7.txt -->\n```text\nIt falls.\n```\n' > "$tree/docs/motion.md"
    printf '<svg>\n<g id="f1"/>\n<g id="f2"/>\n</svg>\n' > "$tree/docs/pictures/1.7-film.svg"
    printf '<svg>\n</svg>\n' > "$tree/docs/pictures/1.7-sheet.svg"
    # shellcheck disable=SC2016
    printf '%s\n' '#!/bin/sh' 'echo "It falls."' 'cp "'"$ANSATZ_SCRATCH"'/drawn/"*.svg "$ANSATZ_PICTURES/"' > "$build/chapters/section_1.7"
    chmod +x "$build/chapters/section_1.7"
    rm -rf "$ANSATZ_SCRATCH/drawn"
    cp -R "$tree/docs/pictures" "$ANSATZ_SCRATCH/drawn"
}
# <good, or words of the refusal> <the test>
expect() {
    local words=$1 said status=0
    said=$(ANSATZ_SCRATCH=$ANSATZ_SCRATCH/run ANSATZ_BUILD=$build bash "$project/tests/tools/$2" "$tree" 2>&1) || status=$?
    if [ "$words" = good ]; then
        [ $status -eq 0 ] || { printf '%s refuses what holds no fault:\n%s\n' "$2" "$said"; exit 1; }
    else
        [ $status -ne 0 ] || { printf '%s is content, where it should say: %s\n' "$2" "$words"; exit 1; }
        [[ $said == *"$words"* ]] || { printf '%s should say "%s", but says:\n%s\n' "$2" "$words" "$said"; exit 1; }
    fi
    passed=$((passed + 1))
    plant
}
mkdir -p "$ANSATZ_SCRATCH/run"
plant
expect good recordings.sh

# ---------------------------------------------------------------- what is printed
sed -i 's/falls/flies/' "$tree/docs/recordings/1.7.txt"
expect "section 1.7 prints something else than docs/recordings/1.7.txt" recordings.sh
rm "$tree/docs/recordings/1.7.txt"
expect "section 1.7 has no recording" recordings.sh
echo 'exit 3' >> "$build/chapters/section_1.7"
expect "section 1.7 failed" recordings.sh
rm "$build/chapters/section_1.7"
expect "section 1.7 is not built" recordings.sh
echo > "$tree/docs/motion.md"
expect "no page includes docs/recordings/1.7.txt" recordings.sh
echo 'Of nobody.' > "$tree/docs/recordings/1.99.txt"
expect "docs/recordings/1.99.txt is no section's" recordings.sh

# ---------------------------------------------------------------- films and sheets
film=$ANSATZ_SCRATCH/drawn/1.7-film.svg
sed -i 's|<g id="f2"/>|<g id="f2">moved</g>|' "$film"
expect "1.7-film.svg is not what section 1.7 draws: 1 frames differ, from 2 to 2" recordings.sh
sed -i '/f2/d' "$film"
expect "2 frames are kept, and 1 are drawn" recordings.sh
sed -i 's|<svg>|<svg width="1">|' "$film"
expect "its frames are the same, and its head or its scenery differs" recordings.sh
echo '<svg/>' > "$ANSATZ_SCRATCH/drawn/1.7-sheet.svg"
expect "1.7-sheet.svg is not what section 1.7 draws" recordings.sh
rm "$tree/docs/pictures/1.7-sheet.svg"
expect "docs/pictures/1.7-sheet.svg is not kept" recordings.sh
rm "$film"
expect "1.7-film.svg is kept, and section 1.7 draws no such film" recordings.sh

# ---------------------------------------------------------------- the programs of the README
expect good readme.sh
sed -i '0,/World sky/s//World ground/' "$tree/README.md"
expect "Listing 1 of README.md is not tests/package/engine.cpp" readme.sh
echo '// changed' >> "$tree/tests/package/pool.cpp"
expect "Listing 2 of README.md is not tests/package/pool.cpp" readme.sh
# shellcheck disable=SC2016
printf '\n```cpp\nint i;\n```\n' >> "$tree/README.md"
expect "README.md should have two listings in C++" readme.sh

echo "$passed faults and their opposites judged rightly"
