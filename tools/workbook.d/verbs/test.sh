# shellcheck shell=bash
# SPDX-License-Identifier: BSL-1.0
#
# build everything and run the tests, or some of them
#
#   ./workbook test
#   ./workbook test -R units      those whose name contains "units"
#   ./workbook test -N            only list them
#   ./workbook test --touched     what depends on a file that was changed since the last commit
#   ./workbook test --touched main   the same since the branch left main, e.g. before a merge
#
#   -R NAME, -E NAME     the tests whose name matches, or all others
#   -L LABEL, -LE LABEL  the same by label; the label of a test is its module
#   --rerun-failed       those that failed in the last run
#   -V                   everything that they print
#   -N                   list what would run, after building it
#
# Every other option of ctest that is about running tests is handed on as well; ctest --help has them. Everything is built first,
# whichever tests are chosen; --touched builds only what it runs.
#
# --touched asks the compiler's own record of what each program was made from, and of those that include a header of the
# library takes the ones that name what is in it: the tests of the changed headers first, then what compiles quickly, as many as
# give a verdict in three minutes, by what the compiler needed before. It builds and runs these, the mistakes that name it with
# g++, and always a few that are quick and find much. What measures time, the other compilers' sentences and the sanitizers are
# left to a whole run, and what would take longer is counted and left, too.
#
# Shows what fails, ctest's closing lines and what took longest; the whole log is build/logs/test.log.

# The options of ctest, which answers none of its own questions here: --help is ours, and --version asks for no test. It passes over
# what it does not know and runs all tests, so they are asked for before. Where it is not installed yet, everything may be one.
options_of_test() {
    command -v ctest > /dev/null || { echo ANY; return; }
    ctest --help | awk '
        /^Generators|^$/ && options { exit }
        /^Options$/ { options = 1; next }
        !options || !/^  -/ { next }
        {
            sub(/ *= [A-Z].*/, "")
            value = / <|\[Start|\[0|until|after/ ? " VALUE" : ""
            while (match($0, /(^|[ ,])--?[A-Za-z][A-Za-z0-9.-]*\[?=?/)) {
                name = substr($0, RSTART, RLENGTH); $0 = substr($0, RSTART + RLENGTH)
                sub(/^[ ,]*/, "", name)
                if (name ~ /^--?([hH]|help.*|usage|version|preset|list-presets|test-dir)[[=]*$/) continue
                if (name ~ /=$/) { sub(/\[?=$/, "", name); print name "="; if (!value) print name }
                else { sub(/\[$/, "", name); print name value }
            }
        }'
}

# test_words <arguments...>: a word that is no option's value would be passed over in silence, and all tests be run.
test_words() {
    local most=0
    case " $* " in
        *' --touched '*)
            most=1
            if [ "$1" != --touched ] || [ $# -ne $((1 + ${#WORDS[@]})) ]; then
                complain "--touched stands alone, or with a commit: ./workbook test --touched main"
                return 2
            fi
            ;;
    esac
    if [ ${#WORDS[@]} -gt $most ]; then
        complain "test takes no '${WORDS[most]}'; the tests of a name are chosen by -R: ./workbook test -R ${WORDS[most]}"
        return 2
    fi
    if [ ${#WORDS[@]} -gt 0 ] && ! git rev-parse -q --verify "${WORDS[0]}^{commit}" > /dev/null 2>&1; then
        complain "there is no commit '${WORDS[0]}'"
        return 2
    fi
}

# The files that were changed since a commit, new ones too; touched_files [the commit, HEAD without it]
touched_files() {
    local base=HEAD
    if [ -n "${1:-}" ]; then base=$(git merge-base "$1" HEAD 2> /dev/null) || return 1; fi
    { git diff --name-only "$base" && git ls-files --others --exclude-standard; } | sort -u
}

# The ctests that a change concerns, as a regular expression of ctest, each once; from lines of "<kind> <rest>" (touched.py)
touched_names() {
    {
        echo '^mirror$'
        echo '^tools\.must_not_compile$'
        local kind rest
        while read -r kind rest; do
            rest=${rest//./\\.}
            case $kind in
                section) echo "^section\\.$rest\$" ;;
                exercise) echo "^exercises\\.$rest\$" ;;
                mistake) echo '^must_not_compile\.precompiled\.g\+\+$'; echo "^must_not_compile\\.$rest\\.g\\+\\+\$" ;;
                script) echo "^$rest\$" ;;
            esac
        done
    } | awk '!seen[$0]++' | paste -s -d '|'
}

# How long the compiler may be busy with it, of three minutes to a verdict; the tests take the rest.
TOUCHED_SECONDS=100

# Builds and runs what the changed files concern; touched [the commit]
touched() {
    local files line kind rest targets=() modules=() programs=() left=0 late=0 longer=0 began status=0 log=build/logs/test.log
    began=$(now)
    if [ ! -f "$BUILD/build.ninja" ]; then complain "--touched needs ninja, which knows what each program was made from"; return 2; fi
    files=$(touched_files "${1:-}") || { complain "there is no commit '$1'"; return 2; }
    if [ -z "$files" ]; then echo "Nothing was changed."; return 0; fi
    if grep -q -E '(^|/)CMakeLists\.txt$|\.cmake$|^CMakePresets\.json$' <<< "$files"; then
        say "How the project is built was changed: what that concerns only a whole ./workbook test finds."
    fi
    local chosen
    chosen=$(python3 "$ROOT/tools/workshop/touched.py" "$ROOT" "$BUILD" $((TOUCHED_SECONDS * $(jobs_here))) <<< "$files") || return 1
    while read -r kind rest; do
        case $kind in
            object) targets+=("$rest") ;;
            program) modules+=("${rest%% *}"); programs+=("${rest#* }") ;;
            section) targets+=("section_$rest") ;;
            exercise) targets+=("exercise.$rest.others") ;;
            left) left=$rest ;;
            late) late=${rest% *} longer=${rest#* } ;;
        esac
    done <<< "$chosen"
    echo "$(wc -l <<< "$files" | tr -d ' ') files were changed: ${#targets[@]} objects and programs name what is in them;" \
        "$left more include them and do not (they wait for a whole ./workbook test)"
    [ "$late" -eq 0 ] ||
        echo "$late more name it, too, and would take $(duration $((1000 * longer / $(jobs_here)))) longer: a whole ./workbook test runs them"
    build "what was touched" "${targets[@]}" "tests/CMakeFiles/test_main.dir/main.cpp.o" || return 1
    # The tests of a module that were chosen, in a program of their own: the others need not be compiled.
    mkdir -p "$BUILD/touched"
    for line in "${!modules[@]}"; do
        (cd "$BUILD" && eval "${programs[line]}") || return 1
        progress "tests of ${modules[line]}"
        "$BUILD/touched/test_${modules[line]}" > "$log" 2>&1 < /dev/null && continue
        clear_progress
        cat "$log"
        status=1
    done
    clear_progress
    ctest --test-dir "$BUILD" --output-on-failure --no-tests=error -j "$(jobs_here)" -R "$(touched_names <<< "$chosen")" \
        -LE '^perf$|every_compiler' 2>&1 < /dev/null | tee "$log" | grep -v -E '^ +Start +[0-9]+:| Passed |^Internal ctest|^Test project '
    [ "${PIPESTATUS[0]}" -eq 0 ] || status=1
    echo "the tests of ${modules[*]}: $([ $status -eq 0 ] && echo passed || echo FAILED) after $(duration $(($(now) - began)))"
    return $status
}

verb_test() {
    test_words "$@" || return 2
    provide || return 1
    configure || return 1
    if [ "${1:-}" = --touched ]; then touched "${2:-}"; return; fi
    local began
    began=$(date +%s)
    build "everything" || return 1
    local argument log=build/logs/test.log line status
    local run=(ctest --test-dir "$BUILD" --output-on-failure --no-tests=error -j "$(jobs_here)" "$@")
    for argument in "$@"; do
        case $argument in
            # Asked to talk: then nothing is kept back.
            -N | --show-only* | -V | -VV | --verbose | --extra-verbose | --print-labels)
                "${run[@]}"
                return
                ;;
        esac
    done
    "${run[@]}" 2>&1 < /dev/null | tee "$log" | while IFS= read -r line; do
        if [[ $line =~ ^\ *([0-9]+/[0-9]+)\ Test\ +#[0-9]+:\ (.*)\ \.\..*(Passed|Skipped)\  ]]; then
            progress "test ${BASH_REMATCH[1]} ${BASH_REMATCH[2]%% ..*}"
        elif [[ $line =~ ^(\ +Start\ +[0-9]+:|Internal\ ctest|Test\ project\ ) ]]; then :
        elif [ -n "$line" ]; then
            clear_progress
            printf '%s\n' "$line"
        fi
    done
    status=${PIPESTATUS[0]}
    clear_progress
    # Tests that were chosen say nothing about where all the time goes.
    if [ $# -eq 0 ] && keep_times "$began"; then
        echo
        echo "Where the time went (all of it: ./workbook doctor --times), in seconds over all jobs:"
        times_table 5
    fi
    return "$status"
}
