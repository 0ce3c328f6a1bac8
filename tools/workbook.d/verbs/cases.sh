# shellcheck shell=bash
# SPDX-License-Identifier: BSL-1.0
#
# the hard cases: what each asks, and what was measured here
#
#   ./workbook cases              run the tests of all rows with what is built, and show every row
#   ./workbook cases C R9         only a group by its letter, or a row by its name: a few rows with their tests
#   ./workbook cases --all        also the tests that compile programs of their own, for minutes
#   ./workbook cases --last       run nothing: what the last runs said, those of ./workbook test too
#
# Nothing is built: ./workbook test does that. The rows are tests/hard_cases.txt; the table goes to build/cases/cases.json
# as well, and ./workbook docs shows it on the page "Hard cases". Ends with 1 where a row failed.

verb_cases() {
    local argument last=false all=() words=() selected refused status log listed=build/cases/listed.json
    for argument in "$@"; do
        case $argument in
            --last) last=true ;;
            --all) all=(--all) ;;
            *) words+=("$argument") ;;
        esac
    done
    if ! command -v python3 > /dev/null; then complain "cases needs python3 (on Debian: apt install python3)"; return 1; fi
    # A word that is no row is told before anything runs.
    if ! refused=$(python3 tools/workshop/cases.py select ${words[@]+"${words[@]}"} <<< '{"tests": []}' 2>&1); then
        complain "$(head -n 1 <<< "$refused")"
        say "$(tail -n +2 <<< "$refused")"
        return 2
    fi
    mkdir -p build/cases
    if ! $last; then
        if [ ! -f "$BUILD/CTestTestfile.cmake" ]; then
            complain "nothing is built in $BUILD; ./workbook test builds the tests, ./workbook cases --last shows the rows"
            return 1
        fi
        ctest --test-dir "$BUILD" --show-only=json-v1 > "$listed" 2> /dev/null < /dev/null
        selected=$(python3 tools/workshop/cases.py select ${all[@]+"${all[@]}"} ${words[@]+"${words[@]}"} < "$listed") || return 1
        if [ -z "$selected" ]; then
            say "None of these tests is built here; ./workbook test builds them."
        else
            progress "running the tests of the hard cases"
            ctest --test-dir "$BUILD" -j "$(jobs_here)" -I "$selected" > build/cases/said.txt 2>&1 < /dev/null
            clear_progress
            # ctest keeps one log alone. A run of some rows says nothing of the others, so several are kept.
            log=build/cases/$(now).log
            cp "$BUILD/Testing/Temporary/LastTest.log" "$log" || return 1
            find build/cases -name '*.log' | LC_ALL=C sort -r | tail -n +11 | while IFS= read -r log; do rm -f "$log"; done
        fi
    fi
    WIDTH=$WIDTH python3 tools/workshop/cases.py table "$BUILD" ${words[@]+"${words[@]}"}
    status=$?
    python3 tools/workshop/cases.py json "$BUILD" > build/cases/cases.json.new && mv build/cases/cases.json.new build/cases/cases.json
    if ! $last; then echo "As JSON: build/cases/cases.json."; fi
    return $status
}
