# shellcheck shell=bash
# SPDX-License-Identifier: BSL-1.0
#
# build and run one section, and show what it prints and draws
#
#   ./workbook section 1.6.2      one section
#   ./workbook section 1.6        1.6 and everything below it: 1.6.1, 1.6.2, ...
#   ./workbook section 1          a whole chapter
#   ./workbook section            the list of them

# shellcheck source=/dev/null
. "$ROOT/tools/workbook.d/verbs/list.sh"

verb_section() {
    if [ $# -eq 0 ]; then
        verb_list
        echo
        echo "./workbook section <number> runs one."
        return 0
    fi
    if [ $# -gt 1 ]; then complain "one section at a time, or all below a number; what is '$2'?"; return 2; fi
    local index chosen number
    index=$(section_index)
    chosen=$(at_or_below "$index" "${1%.}")
    if [ -z "$chosen" ]; then no_section "$1" "$index"; return 2; fi
    provide || return 1
    configure || return 1
    local targets=()
    while IFS= read -r number; do targets+=("section_$number"); done <<< "$(numbers "$chosen")"
    local what="section $1"
    [ ${#targets[@]} -gt 1 ] && what="${#targets[@]} sections"
    build "$what" "${targets[@]}" || return 1

    local title claim file failed=0 log
    while IFS=$SEP read -r number title claim file; do
        heading "$number $title"
        [ -n "$claim" ] && say "$DIM$claim$PLAIN"
        echo
        log=build/logs/section-$number.log
        if run_section "$number" "$file"; then
            cat "$SECTIONS/$number.txt"
        else
            failed=$((failed + 1))
            complain "section $number failed"
            cat "$log" >&2
        fi
        grep '^picture skipped' "$log"
        echo
        pictures_of "$number" | sed 's/^/picture: /'
        echo "source:  $file"
        exercise_index | awk -F '\037' -v number="$number" '$1 == number { sub(/^[^.]*\./, "", $2); print "exercise: ./workbook exercise " $2 }'
        [ "$number" != "$(numbers "$chosen" | tail -n 1)" ] && echo
    done <<< "$chosen"
    [ "$failed" -eq 0 ]
}
