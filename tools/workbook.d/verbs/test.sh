# shellcheck shell=bash
# SPDX-License-Identifier: BSL-1.0
#
# build everything and run the tests; arguments go to ctest
#
#   ./workbook test
#   ./workbook test -R units      those whose name contains "units"
#   ./workbook test -N            only list them
#
# Shows what fails and ctest's closing lines; the whole log is build/logs/test.log.

verb_test() {
    provide || return 1
    configure || return 1
    build "everything" || return 1
    local argument log=build/logs/test.log line status
    local run=(ctest --test-dir "$BUILD" --output-on-failure --no-tests=error -j "$(jobs_here)" "$@")
    for argument in "$@"; do
        case $argument in
            # Asked to talk: then nothing is kept back.
            -N | --show-only* | -V | -VV | --verbose | --extra-verbose | --print-labels | --help*)
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
    return "$status"
}
