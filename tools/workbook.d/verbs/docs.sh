# shellcheck shell=bash
# SPDX-License-Identifier: BSL-1.0
#
# build the documentation site: chapters, exercises, the library
#
#   ./workbook docs
#
# The site needs no server and no network: open build/docs/html/index.html. Pictures come from the sections: what has been
# built is run for those that are missing. With a display, a browser is opened; ANSATZ_NO_BROWSER=1 keeps it closed.

# The numbers of the sections whose pictures a chapter shows, and which are not drawn yet.
sections_without_picture() {
    local picture
    cat docs/*.md 2>/dev/null | grep -oE '"picture [^ "]+' | awk '{ print $2 }' | sort -u -V | while IFS= read -r picture; do
        if [ -f "docs/pictures/$picture" ] || [ -f "$PICTURES/$picture" ]; then continue; fi
        picture=${picture%.svg}
        echo "${picture%%-*}"
    done | uniq
}

draw_missing_pictures() {
    local missing number file left count=0
    missing=$(sections_without_picture)
    [ -z "$missing" ] && return 0
    if command -v gnuplot > /dev/null || command -v dot > /dev/null; then
        while IFS= read -r number; do
            file=$(section_index | awk -F '\037' -v number="$number" '$1 == number { print $4 }')
            if [ -n "$file" ] && [ -n "$(section_program "$BUILD" "$file")" ]; then
                progress "drawing the picture of section $number"
                run_section "$number" "$file" && count=$((count + 1))
            fi
        done <<< "$missing"
        clear_progress
        [ "$count" -gt 0 ] && echo "ran $count sections for their pictures"
    fi
    left=$(sections_without_picture | tr '\n' ' ')
    [ -z "$left" ] && return 0
    if command -v gnuplot > /dev/null && command -v dot > /dev/null; then
        say "${YELLOW}Not drawn yet: the pictures of section ${left% }.$PLAIN The site says so in their place. ./workbook builds the sections and draws them; then give this command again."
    else
        say "${YELLOW}Not drawn: the pictures of section ${left% }.$PLAIN gnuplot or Graphviz is missing here; ./workbook installs it and draws them. The site says so in their place."
    fi
}

verb_docs() {
    if [ $# -gt 0 ]; then complain "docs takes no '$1'; ./workbook help docs"; return 2; fi
    # Without its theme the site is plain, and complete.
    provide docs || { command -v doxygen > /dev/null && [ -n "$(needs | awk -F '|' '$3 == "libjs-mathjax" { print $2 }')" ] &&
        say "The site is built without its theme."; } || return 1
    draw_missing_pictures
    local start log=build/logs/docs.log status page=build/docs/html/index.html
    mkdir -p build/logs
    start=$(now)
    $LIVE || echo "building the site (log: $log)"
    progress "building the site"
    tools/docs/build build > "$log" 2>&1 < /dev/null
    status=$?
    clear_progress
    if [ $status -ne 0 ]; then
        complain "the site has faults; the first of them:"
        sed "s|$ROOT/||g" "$log" | grep . | head -n 8 >&2
        say "All of them: $log.$([ -f $page ] && echo " What could be built is in $page.")"
        return 1
    fi
    echo "built the site in $(duration $(($(now) - start))): $(grep -oE '[0-9]+ pages' "$log" | head -n 1)"
    remember "build the site" $(($(now) - start))
    echo
    echo "  the site    $page"
    if [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ] && [ -z "${ANSATZ_NO_BROWSER:-}" ] && [ -t 1 ] && command -v xdg-open > /dev/null; then
        xdg-open "$page" > /dev/null 2>&1 < /dev/null &
    else
        echo "              open it in a browser; it needs neither a server nor a network"
    fi
}
