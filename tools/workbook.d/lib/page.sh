# shellcheck shell=bash
# SPDX-License-Identifier: BSL-1.0
#
# The contact page of the tour: every section with what it printed and drew, in one file that needs
# nothing else. Pictures stand in it as base64, because the names inside an SVG would collide.

PAGE=build/tour.html

escape() { sed -e 's/&/\&amp;/g' -e 's/</\&lt;/g' -e 's/>/\&gt;/g'; }

picture_tag() {
    local file=$1 alt=$2
    printf '<img alt="%s" src="data:image/svg+xml;base64,' "$(printf '%s' "$alt" | escape | sed 's/"/\&quot;/g')"
    base64 < "$file" | tr -d '\n'
    printf '">\n'
}

page_head() {
    cat << 'HTML'
<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Ansatz: the tour</title>
<style>
:root { --ink: #1d232b; --soft: #5b6673; --line: #e2e6ea; --paper: #f6f7f9; --card: #ffffff; --accent: #0072b2; }
* { box-sizing: border-box; }
html { scroll-behavior: smooth; scroll-padding-top: 1rem; }
body { margin: 0; background: var(--paper); color: var(--ink); font: 16px/1.55 system-ui, "DejaVu Sans", Verdana, sans-serif; }
.layout { display: grid; grid-template-columns: 17rem minmax(0, 1fr); max-width: 92rem; margin: 0 auto; }
nav { position: sticky; top: 0; align-self: start; max-height: 100vh; overflow: auto; padding: 2rem 1rem 2rem 1.5rem; font-size: .875rem; }
nav h2 { font-size: .8rem; color: var(--soft); margin: 1.2rem 0 .3rem; font-weight: 600; }
nav a { display: block; padding: .15rem 0; color: inherit; text-decoration: none; }
nav a:hover { color: var(--accent); }
nav b, .number { color: var(--accent); font-weight: 600; font-variant-numeric: tabular-nums; margin-right: .45em; }
main { padding: 2rem 1.5rem 4rem; min-width: 0; }
h1 { font-size: 1.9rem; line-height: 1.2; margin: 0 0 .4rem; }
.about { color: var(--soft); margin: 0 0 2rem; max-width: 46rem; }
h2.chapter { font-size: 1.35rem; margin: 2.5rem 0 1rem; padding-bottom: .4rem; border-bottom: 2px solid var(--line); }
article { background: var(--card); border: 1px solid var(--line); border-radius: 10px; padding: 1.3rem 1.5rem 1.5rem; margin: 0 0 1.4rem; }
article h3 { margin: 0; font-size: 1.12rem; }
.claim { margin: .15rem 0 0; color: var(--soft); }
.source { font: .8rem ui-monospace, "DejaVu Sans Mono", monospace; color: var(--soft); margin: .3rem 0 0; }
img { display: block; width: 100%; max-width: 820px; height: auto; margin: 1rem 0 0; background: #fff; }
.wide img { max-width: 1100px; }
pre { margin: 1rem 0 0; padding: .9rem 1rem; background: var(--paper); border-radius: 6px; overflow-x: auto; font: .82rem/1.5 ui-monospace, "DejaVu Sans Mono", monospace; }
.failed { border-color: #d55e00; } .failed .claim { color: #b04a00; }
@media (max-width: 60rem) { .layout { display: block; } nav { position: static; max-height: none; padding-bottom: 0; } article { padding: 1rem; } }
@media print { nav { display: none; } .layout { display: block; } article { break-inside: avoid; } }
</style>
</head>
<body>
<div class="layout">
HTML
}

# make_page <index>: reads build/sections and build/pictures, writes build/tour.html whole or not at all.
make_page() {
    local index=$1 number title claim file chapter last='' picture
    mkdir -p build
    {
        page_head
        echo '<nav aria-label="Sections">'
        while IFS=$SEP read -r number title claim file; do
            chapter=$(chapter_title "$file")
            if [ "$chapter" != "$last" ]; then
                printf '<h2>%s. %s</h2>\n' "${number%%.*}" "$(printf '%s' "$chapter" | escape)"
                last=$chapter
            fi
            printf '<a href="#s%s"><b>%s</b>%s</a>\n' "$number" "$number" "$(printf '%s' "$title" | escape)"
        done <<< "$index"
        [ -n "$(cost_pictures)" ] && echo '<h2>Costs</h2><a href="#costs">What accuracy costs</a>'
        printf '</nav>\n<main>\n<h1>Ansatz: the tour</h1>\n'
        printf '<p class="about">Every section of the course, as it ran on this machine on %s: %s sections, %s pictures. Each is a small program; its name stands under its title.</p>\n' \
            "$(date '+%Y-%m-%d at %H:%M')" "$(printf '%s\n' "$index" | grep -c .)" "$(find "$PICTURES" -name '*.svg' 2>/dev/null | grep -c .)"
        last=''
        while IFS=$SEP read -r number title claim file; do
            chapter=$(chapter_title "$file")
            if [ "$chapter" != "$last" ]; then
                printf '<h2 class="chapter">%s. %s</h2>\n' "${number%%.*}" "$(printf '%s' "$chapter" | escape)"
                last=$chapter
            fi
            page_section "$number" "$title" "$claim" "$file"
        done <<< "$index"
        page_costs
        printf '</main>\n</div>\n</body>\n</html>\n'
    } > "$PAGE.part" && mv -f "$PAGE.part" "$PAGE"
}

page_section() {
    local number=$1 title=$2 claim=$3 file=$4 picture
    local output=$SECTIONS/$number.txt
    if [ -f "$output" ]; then printf '<article id="s%s">\n' "$number"; else printf '<article id="s%s" class="failed">\n' "$number"; fi
    printf '<h3><span class="number">%s</span>%s</h3>\n' "$number" "$(printf '%s' "$title" | escape)"
    if [ ! -f "$output" ]; then
        printf '<p class="claim">This section did not run; its log is build/logs/section-%s.log.</p>\n' "$number"
    elif [ -n "$claim" ]; then
        printf '<p class="claim">%s</p>\n' "$(printf '%s' "$claim" | escape)"
    fi
    printf '<p class="source">%s</p>\n' "$(printf '%s' "$file" | escape)"
    pictures_of "$number" | while IFS= read -r picture; do picture_tag "$picture" "Picture of section $number, $title"; done
    [ -s "$output" ] && { printf '<pre>'; escape < "$output"; printf '</pre>\n'; }
    printf '</article>\n'
}

cost_pictures() {
    local file
    for file in build/costs/*.svg; do [ -f "$file" ] && echo "$file"; done
    return 0
}
page_costs() {
    local picture
    [ -z "$(cost_pictures)" ] && return 0
    printf '<h2 class="chapter" id="costs">What accuracy costs</h2>\n<article class="wide">\n'
    printf '<p class="claim">Error against time and against the count of work, from the last <code>./workbook costs</code> on this machine. Down and left is better; the tables lie in build/costs.</p>\n'
    cost_pictures | while IFS= read -r picture; do picture_tag "$picture" "Work and precision: ${picture##*/}"; done
    printf '</article>\n'
}
