# shellcheck shell=bash
# SPDX-License-Identifier: BSL-1.0
#
# take the tour: install, build, run every section, make a page
#
#   ./workbook            or   ./workbook tour [--yes]
#
# Packages are installed with apt, as root at once, otherwise with sudo after asking; --yes (or CI=true)
# answers yes. A section that fails does not stop the others. Run it again at any time: what is built
# is kept.

verb_tour() {
    if [ $# -gt 0 ]; then
        complain "the tour takes no '$1'; ./workbook section $1 shows one section"
        return 2
    fi
    local start index count
    start=$(now)
    heading "Ansatz: the tour of the course"
    provide || return 1
    index=$(section_index)
    if [ -z "$index" ]; then
        complain "there is no section in chapters/ yet"
        return 1
    fi
    count=$(printf '%s\n' "$index" | grep -c .)
    local before
    if before=$(last_duration "build $count sections"); then
        say "A whole build took $(duration "$before") here; what has not changed is not built again."
    else
        say "The first time everything is compiled: on an idle machine count on about ten seconds a section for each core, $count sections. After that only what changed."
    fi
    configure || return 1
    local number failed_build=false
    local targets=()
    while IFS= read -r number; do targets+=("section_$number"); done <<< "$(numbers "$index")"
    # One section that does not compile must not keep the others from being built.
    if ! KEEP_GOING=true build "$count sections" "${targets[@]}"; then failed_build=true; fi

    run_all "$index" "$count"
    local failures=$?
    if [ "$failures" -eq "$count" ]; then return 1; fi
    make_page "$index"

    local drawn
    drawn=$(find "$PICTURES" -name '*.svg' 2>/dev/null | grep -c .)
    echo
    if [ "$failures" -eq 0 ]; then
        heading "All $count sections ran, $(duration $(($(now) - start))) in all."
    else
        heading "$((count - failures)) of $count sections ran, $(duration $(($(now) - start))) in all."
    fi
    echo "  the page    $PAGE      open it in a browser: every section, its output, its pictures"
    echo "  outputs     $SECTIONS/"
    [ "$drawn" -gt 0 ] && echo "  pictures    $PICTURES/      $drawn of them"
    ls build/costs/*.json > /dev/null 2>&1 && echo "  cost tables build/costs/"
    echo
    echo "Next:  ./workbook exercise        the first exercise: what to edit, and whether it is right"
    echo "       ./workbook section 1.6.1   one section, in the terminal"
    echo "       ./workbook costs --quick   what accuracy costs on this machine"
    echo "       ./workbook help            everything else"
    if [ "$failures" -gt 0 ] || $failed_build; then return 1; fi
}

# run_all <index> <count>: the result is the number of sections that failed (at most 100).
run_all() {
    local index=$1 count=$2 number title file i=0 failed=0 start took label room
    while IFS=$SEP read -r number title _ file; do
        i=$((i + 1))
        start=$(now)
        room=$((WIDTH > 76 ? 52 : WIDTH - 26))
        label=$(printf '[%*d/%d] %s' "${#count}" "$i" "$count" "$(fit "$number $title" "$room")")
        progress "$label ..."
        if run_section "$number" "$file"; then
            took=$(($(now) - start))
            clear_progress
            echo "$label ${GREEN}ok${PLAIN} $(duration $took)"
        else
            clear_progress
            failed=$((failed + 1))
            echo "$label ${RED}failed${PLAIN}"
            # A claim that does not hold says most; else what the program said before it stopped.
            { grep -m 3 -F '[FAILS]' "build/logs/section-$number.log" ||
                grep -v '^picture: ' "build/logs/section-$number.log" | head -n 3; } | sed 's/^ */        /'
            echo "        the whole log: build/logs/section-$number.log"
        fi
    done <<< "$index"
    return $((failed > 100 ? 100 : failed))
}
