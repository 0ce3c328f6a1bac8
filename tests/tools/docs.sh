#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
#
# The site is built without a warning or a fault; and tools/docs/check finds each fault that is put into it.
#
# usage: docs.sh <folder of the project>
#
# Looks at every compiler: none of them has a say in it, so once on a machine is enough.
# Works on a copy of the sources in ANSATZ_SCRATCH.
set -euo pipefail
project=$1
if ! command -v doxygen > /dev/null; then echo "skipped: no doxygen (on Debian: apt install doxygen)"; exit 0; fi
if ! command -v python3 > /dev/null; then echo "skipped: no python3 (on Debian: apt install python3)"; exit 0; fi
if [ ! -f "${ANSATZ_MATHJAX:-/usr/share/javascript/mathjax}/MathJax.js" ]; then
    echo "skipped: no MathJax 2 for the formulas (on Debian: apt install libjs-mathjax)"
    exit 0
fi

rm -rf "$ANSATZ_SCRATCH"
mkdir -p "$ANSATZ_SCRATCH"
scratch=$(cd "$ANSATZ_SCRATCH" && pwd -P)
tree=$scratch/project
copy_sources() {
    rm -rf "$tree"
    mkdir -p "$tree"
    local entry
    for entry in README.md CHANGELOG.md LICENSE CMakeLists.txt Doxyfile workbook chapters docs exercises include tests tools; do
        cp -R "$project/$entry" "$tree/"
    done
}

# ---------------------------------------------------------------- the site as it is
copy_sources
# But for one picture, which is not kept yet.
rm "$tree/docs/pictures/1.7.svg"
sed -i 's|^!\(\[.*\]\)(pictures/1\.7\.svg)$|Picture: \1(../chapters/1-motion/1.7-drag.cpp "picture 1.7.svg")|' "$tree/docs/motion.md"
if ! "$tree/tools/docs/build" "$scratch/build" > "$scratch/log" 2>&1; then
    echo "The site has warnings or faults (tools/docs/build says the same):"
    sed "s|$tree/||g" "$scratch/log" | head -n 60
    exit 1
fi
cat "$scratch/log"
html=$scratch/build/docs/html
# A doubt of Doxygen that is no warning would be in the log as well.
if grep -qE '(warning|error):' "$scratch/log"; then echo "Doxygen complained, and the build let it pass"; exit 1; fi

# ---------------------------------------------------------------- the site as it is seen
# What is wider than its box, on a screen of 1200 pixels: no listing with lines of 120 characters, and no table.
too_wide() {
    local page=$html/measured.html
    awk '/<\/body>/ {
        print "<script>window.addEventListener(\"load\", () => setTimeout(() => { const cut = [];"
        print "document.querySelectorAll(\"div.fragment, table\").forEach(box => {"
        print "  const longest = Math.max(0, ...[...box.querySelectorAll(\".line\")].map(line => line.textContent.length));"
        print "  if (box.offsetParent && box.scrollWidth > box.clientWidth + 1 && longest <= 120) cut.push(box.textContent.trim().slice(0, 40)); });"
        print "document.title = \"cut: \" + cut.length + \" \" + cut.join(\", \"); }, 1500));</script>"
    } { print }' "$html/$1" > "$page"
    timeout 60 chromium --headless --no-sandbox --disable-gpu --allow-file-access-from-files --user-data-dir="$scratch/chromium" \
        --virtual-time-budget=8000 --window-size=1200,900 --dump-dom "file://$page" 2> /dev/null | tr '\n' ' ' | grep -o '<title>cut: [^<]*' || echo "<title>nothing was measured"
    rm "$page"
}
if command -v chromium > /dev/null; then
    for page in page_world.html chapter_motion.html section_1_6_3.html motion_costs.html section_6_1.html index.html; do
        seen=$(too_wide $page)
        if [ "${seen# }" != "<title>cut: 0 " ]; then echo "$page on a screen of 1200 pixels: ${seen#<title>}"; exit 1; fi
    done
else
    echo "no chromium here: that nothing is cut off was not looked at"
fi

# ---------------------------------------------------------------- what is not drawn says how to draw it
if ! grep -q 'Not drawn yet. ./workbook section 1.7 draws it' "$html/1.7.svg"; then
    echo "The stand-in of a picture does not say how to get the picture"
    exit 1
fi

# ---------------------------------------------------------------- what is searched is found
# finds <word> <title>: an entry of the search for the word is of that title.
finds() {
    if ! grep -hE "^  \['$1_topics[0-9]+'," "$html"/search/all_*.js | grep -F ",['$2'," > /dev/null; then echo "The search does not find '$2' by '$1'"; exit 1; fi
}
finds drag "1.7 Drag"
finds drag "Exercise 1.7: Drag"
for section in "1.6.1 Explicit Euler" "1.6.2 Implicit Euler" "1.6.3 Semi-implicit Euler"; do finds euler "$section"; done
finds symplectic "1.6.3 Semi-implicit Euler"
finds momentum "1.4 Law of conservation of momentum"
finds 1_2e7 "1.7 Drag"
# Words that a player of games would look for, and words of the glossary.
finds friction "Beyond the notes"
finds tunnelling "2.1.2.3 A step that is too large"
finds restitution "2.2.1 Impulse"
finds bounce "2.2.1 Impulse"
finds aabb "2.1.1.1 Bounding box test"
finds quadtree "2.1.1.3 Binary search partitioning"
finds slop "2.2 Response"
finds sleep "1.8 Rest"
finds 6_2e1 "6.1 The A* algorithm"
# Words of the course by which nothing is titled, and several words as they are typed (a blank is _20, a hyphen _2d, an asterisk _2a).
finds energy "1.6 Numerical integration"
finds rk4 "1.6 Numerical integration"
finds projectile "1.5 SUVAT equations"
finds jitter "2.2 Response"
finds instability "3.5 The stable step"
finds dijkstra "6.1 The A* algorithm"
finds pathfinding "Chapter 6: path finding"
finds cbs "6.3.11 All together"
finds cfl "7.2.1 The longest step"
finds install "At a glance"
finds determinism "A world, from outside and from inside"
finds navier_20stokes "7 Why not everything"
finds runge_20kutta "1.6 Numerical integration"
finds k_2dd_20tree "2.1.1.3 Binary search partitioning"
finds flow_20field "6.3.7 A field for a horde"
finds hpa_2a "6.3.12 From gate to gate"
finds critical_20damping "3.1 The damped spring"
# The course comes first; members of the frame's insides are not found, types that users name are.
for list in "$html"/search/all_*.js; do
    if awk '/_topics[0-9]+/ { if (other) exit 1; next } /^  \[/ { other = 1 }' "$list"; then continue; fi
    echo "${list##*/} has an entry of the course behind others"
    exit 1
done
if grep -h "classansatz_1_1ContactLists.html#" "$html"/search/*.js; then echo "The search finds members of the frame"; exit 1; fi
grep -q '"classansatz_1_1World.html"' "$html/annotated.html" || { echo "The list of types has no World"; exit 1; }
if grep -E 'hook_1_1|MotionDoor|TearableRow' "$html/annotated.html" "$html/annotated.js"; then echo "The list of types has insides"; exit 1; fi

# ---------------------------------------------------------------- what leads on
says() { # <page> <text>
    grep -qF -e "$2" "$html/$1" || { echo "$1 should have: $2"; exit 1; }
}
says index.html 'class="front-way"'
says chapter_collision.html 'rel="prev" href="motion_sources.html"'
says chapter_collision.html 'rel="next" href="section_2_1.html"'
says section_2_1_1.html 'rel="prev" href="section_2_1.html"'
says section_2_1_1.html 'href="chapter_collision.html">Chapter 2: collision</a>'
says chapter_collision.html 'href="section_2_1_1_4.html">2.1.1.4 Sort and sweep</a>'
says exercise_motion_drag.html '<details><summary>Task 1: a question</summary>'
says exercise_motion_drag.html 'class="comment"'
says page_course.html 'href="exercise_motion_drag.html"'
says chapter_motion.html 'Boost Software License 1.0</a>'
says model_effect.html 'rel="prev" href="model_driver.html"'
says classansatz_1_1World.html 'A world: the list of what happens in it'
says classansatz_1_1World.html '&lt;<a class="el" href="world_8hpp_source.html">ansatz/world.hpp</a>&gt;'
says structansatz_1_1Octree.html 'href="exercise_collision_octree_split.html">octree_split</a>'
says page_library.html 'collision/<wbr/>broadphase/<wbr/>all_<wbr/>pairs.hpp</a>'

# ---------------------------------------------------------------- words are words
# A link is for what is named, not for what only looks like it: a parameter x (a cell.x is a member, and so is what a
# line declares: "Length x;"), a sentence that begins with "Keep".
for word in '[^.]<a [^>]*>[xyz]</a>,' '[^.]<a class="(el|code hl_function)"[^>]*>[xyz]</a>;' '>Keep</a> (the|it)' '>Zero</a> (by|if|for)' 'L\. <a [^>]*>Verlet</a>'; do
    if grep -rlE --include='*.html' "$word" "$html"; then echo "has a link where there is only a word: $word"; exit 1; fi
done
if grep -o '<a [^>]*>after</a>' "$html/exercise_motion_suvat.html"; then echo "The student's after() is not the library's"; exit 1; fi
if grep -rl --include='*.html' 'hard case [A-Z][0-9]' "$html"; then echo "speaks of hard cases by numbers that no reader knows"; exit 1; fi

# ---------------------------------------------------------------- each fault is found
checked=0
# A check of the whole site takes seconds, so that faults of different pages are planted together, and looked for together.
wanted=() changed=() most=1

# keep <file>: found puts it back as it is now.
keep() {
    local number=${#changed[@]}
    mkdir -p "$scratch/kept"
    if [ -e "$1" ]; then cp "$1" "$scratch/kept/$number"; else rm -f "$scratch/kept/$number"; fi
    changed+=("$1")
}
put_back() {
    local number
    for ((number = ${#changed[@]} - 1; number >= 0; --number)); do
        if [ -e "$scratch/kept/$number" ]; then cp "$scratch/kept/$number" "${changed[number]}"; else rm -f "${changed[number]}"; fi
    done
    changed=()
}
# reports <what the check must say> [how many lines it is, if not one]
reports() {
    wanted+=("$1")
    most=$((most + ${2:-1}))
}
# found: the check fails on the site, says what it must and nothing else, and what was planted is put back.
found() {
    local said sentence
    if said=$("$tree/tools/docs/check" "$html" 2>&1); then
        printf 'The check is content, where it should say:\n'
        printf '    %s\n' "${wanted[@]}"
        exit 1
    fi
    for sentence in "${wanted[@]}"; do
        if [[ $said != *"$sentence"* ]]; then
            printf 'The check should say\n    %s\nbut it says\n%s\n' "$sentence" "$(head -n 40 <<< "$said")"
            exit 1
        fi
    done
    if [ "$(wc -l <<< "$said")" -gt "$most" ]; then
        printf 'The check should say %d things, but it says\n%s\n' "${#wanted[@]}" "$(head -n 60 <<< "$said")"
        exit 1
    fi
    checked=$((checked + ${#wanted[@]}))
    wanted=() most=1
    put_back
}
mended() {
    "$tree/tools/docs/check" "$html" > /dev/null || { echo "$1"; exit 1; }
}

# planted <file of the site> <text> <what it must say>: with this text before the end of the page.
planted() {
    keep "$html/$1"
    case $1 in
        *.html) awk -v text="$2" '/<\/body>/ { print text } { print }' "$html/$1" > "$scratch/page" && cp "$scratch/page" "$html/$1" ;;
        *) printf '%s\n' "$2" >> "$html/$1" ;;
    esac
    reports "$3"
}
# in_page <text> <what it must say of $page>: the same in one page after the other, so that each is asked for by its name.
mapfile -t pages < <(cd "$html" && printf '%s\n' exercise_*.html)
in_page() {
    page=${pages[0]}
    pages=("${pages[@]:1}")
    planted "$page" "$1" "${2//PAGE/$page}"
}

in_page '<script src="https://polyfill.example/v3/polyfill.min.js"></script>' "PAGE asks another host: https://polyfill.example/v3/polyfill.min.js"
in_page '<script src="//cdn.example/x.js"></script>' "PAGE asks another host: //cdn.example/x.js"
in_page '<img alt="" src="http://example.org/x.png"/>' "PAGE asks another host: http://example.org/x.png"
in_page '<link rel="stylesheet" href="https://fonts.example/a.css"/>' "PAGE asks another host: https://fonts.example/a.css"
in_page '<object data="https://example.org/x.svg"></object>' "PAGE asks another host: https://example.org/x.svg"
in_page '<p style="background: url(https://example.org/x.png)">x</p>' "PAGE asks another host: https://example.org/x.png"
in_page '<script>var a = "https://example.org/x";</script>' "PAGE has a script that names another host"
planted ansatz.css '@import "https://fonts.example/a.css";' "ansatz.css asks another host: https://fonts.example/a.css"
in_page '<a href="nowhere.html">x</a>' "there is no nowhere.html, to which PAGE links"
in_page '<a href="nowhere_2.html#at_all">x</a>' "there is no nowhere_2.html"
in_page '<img alt="" src="nowhere.png"/>' "there is no nowhere.png, to which PAGE links"
in_page '<a href="index.html#nowhere_here">x</a>' "index.html has no place 'nowhere_here', to which PAGE links"
in_page '<a href="#nowhere_here">x</a>' "PAGE has no place 'nowhere_here', to which PAGE links"
# The same in other words: other quotes or none, capitals, a page within a page, tags and styles over several lines.
# shellcheck disable=SC2016
in_page '<script>var a = `https://example.org/x`;</script>' "PAGE has a script that names another host"
in_page '<script>var a = "HTTPS://EXAMPLE.ORG/x";</script>' "PAGE has a script that names another host"
in_page '<script>fetch(a + b);</script>' "PAGE has a script that asks for something"
in_page '<img alt="" src=https://example.org/x.png>' "PAGE asks another host: https://example.org/x.png"
in_page '<IMG ALT="" SRC="HTTPS://example.org/x.png">' "PAGE asks another host: HTTPS://example.org/x.png"
in_page '<iframe srcdoc="&lt;img src=&quot;https://example.org/x.png&quot;&gt;"></iframe>' "PAGE has a page within that names another host"
in_page '<A HREF="nowhere_3.html">x</A>' "there is no nowhere_3.html, to which PAGE links"
in_page '<a href=nowhere_4.html>x</a>' "there is no nowhere_4.html, to which PAGE links"
planted ansatz.css $'a { background: url(\n    "https://example.org/x.png"); }' "ansatz.css asks another host: https://example.org/x.png"
planted ansatz.css '@IMPORT "https://fonts.example/b.css";' "ansatz.css asks another host: https://fonts.example/b.css"
planted ansatz.css 'a { background: image-set("https://example.org/y.png" 1x); }' "ansatz.css asks another host: https://example.org/y.png"
drawing=accuracy_against_time.svg
planted $drawing "<image href='https://example.org/x.png'/>" "$drawing asks another host: https://example.org/x.png"
planted $drawing $'<image\n  xlink:href="https://example.org/y.png"/>' "$drawing asks another host: https://example.org/y.png"
planted $drawing '<feImage href="https://example.org/z.png"/>' "$drawing asks another host: https://example.org/z.png"
planted own.js 'const a = "https://example.org/x";' "own.js has a script that names another host"
planted own_2.js 'new XMLHttpRequest().open("GET", a + b);' "own_2.js has a script that asks for something"
planted search/all_0.html '<a href="nowhere.html">x</a>' "there is no search/nowhere.html, to which search/all_0.html links"
planted navtreedata.js '["A chapter", "@ref nowhere", null]' "navtreedata.js names '@ref nowhere', which no page has"
planted navtreedata.js '["A chapter", "nowhere_5.html", null]' "there is no nowhere_5.html, to which navtreedata.js links"

keep "$html/md__home_somebody_CHANGELOG.html"
cp "$html/page_world.html" "$html/md__home_somebody_CHANGELOG.html"
reports "md__home_somebody_CHANGELOG.html is named after a folder"

# A role is shown by its policies.
planted conceptansatz_1_1EffectIn.html '<h2>Concept definition</h2> detail::HasPlace' "conceptansatz_1_1EffectIn.html shows names of namespace detail"
# without <text of a link> <what it must say> <pages...>: with the link to nowhere else.
without() {
    local link=$1 text=$2 file
    shift 2
    for file in "$@"; do
        keep "$file"
        sed -i "s|href=\"${link}[^\"]*\"|href=\"index.html\"|g" "$file"
    done
    reports "$text"
}
without structansatz "conceptansatz_1_1EffectIn.html names no policy of its kind" "$html/conceptansatz_1_1EffectIn.html"
# An exercise, its section and its header know each other.
without section_ "the exercise drag does not link to its section" "$html/exercise_motion_drag.html"
without drag_8hpp.html "the exercise drag does not link to include/ansatz/motion/drag.hpp" "$html/exercise_motion_drag.html"
for said in "./workbook exercise suvat:its command" "exercises/1-motion/suvat/exercise.hpp:which file to edit"; do
    keep "$html/exercise_motion_suvat.html"
    awk -v text="${said%%:*}" '{ while (i = index($0, text)) $0 = substr($0, 1, i - 1) substr($0, i + length(text)); print }' "$html/exercise_motion_suvat.html" > "$scratch/page"
    cp "$scratch/page" "$html/exercise_motion_suvat.html"
    reports "the page of the exercise suvat does not say ${said#*:}"
done
keep "$html/exercise_motion_suvat.html"
sed -i 's/class="image"/class="text"/' "$html/exercise_motion_suvat.html"
reports "the page of the exercise suvat shows no picture"
found
without exercise_motion_drag.html "no chapter links to the exercise drag" "$html"/chapter_*.html "$html"/section_*.html
mapfile -t of_the_library < <(grep -l 'href="exercise_motion_drag.html' "$html"/struct*.html "$html"/class*.html "$html"/namespace*.html "$html"/*_8hpp.html)
without exercise_motion_drag.html "no page of the API links to the exercise drag" "${of_the_library[@]}"
# Without the copy of MathJax. Every page that loads it has a dead link as well: said once.
keep "$html/mathjax/MathJax.js"
rm "$html/mathjax/MathJax.js"
reports "mathjax/MathJax.js is not in the site" 2
found

# In the sources, each fault in a text of its own: a pasted listing, whether it says what it is or not.
mapfile -t texts < <(cd "$project" && printf '%s\n' exercises/*/*/README.md)
# in_text <text> <what it must say of TEXT> [how many lines it is, if not one]
in_text() {
    text=${texts[0]}
    texts=("${texts[@]:1}")
    keep "$tree/$text"
    printf '\n%s\n' "$1" >> "$tree/$text"
    reports "${2//TEXT/$text}" "${3:-1}"
}
for fence in '```cpp' '```c++' '~~~{.cpp}' '``` cpp' '\code{.cpp}' '```'; do
    in_text "$fence"$'\nint i = 0;\n```' 'a pasted listing, TEXT:'
done
in_text $'    int i = 0;\n    i += 1;' 'a pasted listing, TEXT:'
in_text '<pre>int i = 0;</pre>' 'a pasted listing, TEXT:'
in_text $'```bash\nint i = 0;\n```' 'a pasted listing, TEXT:'
# Formulas, and a picture of nobody.
# shellcheck disable=SC2016
{
    in_text 'The step $x$ is long.' 'a formula would stay as TeX, write $`...`$ on a page and \f$...\f$ in a header: $x$'
    in_text '$$y$$' 'a formula would stay as TeX, write $`...`$ on a page and \f$...\f$ in a header: $$y$$'
    in_text 'The step \f$ x is long.' 'a formula has no end'
    reports 'a forge shows \f$ as it is written'
    in_text '$`\frca{1}{2}`$' 'MathJax knows no \frca'
    in_text '$`\frac{1}{2`$' 'a brace has no partner'
}
in_text 'Picture: [A picture](README.md "picture nopic.svg")' 'TEXT shows nopic.svg, which no section draws' 2
# What a forge would show as it is written, what is quoted and has changed, and links to nowhere.
in_text 'See \ref section_1_7 "1.7".' 'a forge shows \ref as it is written'
in_text $'<!-- snippet: 1-motion/1.7-drag.cpp no_such_piece -->\n```cpp\nint i = 0;\n```' 'what it quotes or links to is otherwise now'
in_text $'<!-- output: docs/recordings/1.7.txt -->\n```text\nTyped by hand.\n```' 'what it quotes or links to is otherwise now'
in_text 'A [link](no_such_file.md).' 'to which it links'
in_text 'A [link](../../../docs/motion.md#section_1_99).' "docs/motion.md has no place 'section_1_99', to which it links"
# The course as one table, and its words.
keep "$tree/docs/motion.md"
sed -i 's/^- Exercise: \[drag\].*$//' "$tree/docs/motion.md"
reports "section 1.7 has no exercise behind '- Exercise:'"
keep "$tree/docs/collision.md"
sed -i 's/^## 2.1 Detection.*$/&\n\nWarm start is told of later./' "$tree/docs/collision.md"
reports "docs/collision.md: section_2_1 uses 'warm start' before collision_beyond explains it"
# Advice without a row, and a table that is not the measured one.
if [ -f "$tree/docs/costs/collision.json" ]; then
    texts=(docs/world.md docs/units.md docs/frame.md)
    in_text 'SortAndSweep is the fastest of all.' "'fastest' has no row"
    in_text 'SortAndSweep is the fastest of all. <!-- costs: collision broadphase/uniform: SortAndSweep < 0.001 AllPairs -->' "does not hold"
    in_text $'<!-- from costs: run collision -->\nOn a fast machine.\n<!-- end of costs -->' "its tables are not those of docs/costs"
fi
found

kept=$tree/docs/world.md
printf '\n```sh\n./workbook docs\n```\n\n```\n wake -> rest\n```\n' >> "$kept"
printf '\n- A list\n\n    goes on; and its second paragraph is no listing;\n\nIt costs $5, and `$x$` is code.\n' >> "$kept"
mended "The check takes a command, or a drawing, or a list for a pasted listing, or a price for a formula"
cp "$project/docs/world.md" "$kept"

# An exercise of which nobody knows.
mkdir -p "$tree/exercises/1-motion/nobody_knows"
printf '# 1.1 Nobody knows\n\nA task.\n' > "$tree/exercises/1-motion/nobody_knows/README.md"
reports "exercises/1-motion/nobody_knows has no page exercise_motion_nobody_knows.html"
found
awk '/<\/body>/ { print "<div class=\"image\"></div><a href=\"section_1_1.html\">1.1</a> ./workbook exercise nobody_knows, exercises/1-motion/nobody_knows/exercise.hpp" } { print }' "$html/page_world.html" > "$html/exercise_motion_nobody_knows.html"
reports "no chapter links to the exercise nobody_knows"
found
rm -r "$tree/exercises/1-motion/nobody_knows" "$html/exercise_motion_nobody_knows.html"
mended "The check finds faults that are mended again"

# What Doxygen says itself, and what it keeps quiet about, in one more build: concepts without a word (only those of a
# namespace that is not detail count), and a reference that leads nowhere.
{
    printf '// SPDX-License-Identifier: BSL-1.0\n#pragma once\n/// \\file\n/// Concepts.\n\nnamespace ansatz {\n'
    printf 'namespace detail {\nstruct Braces {\n    int i{};\n};\ntemplate <class T> concept HiddenAndPlain = true;\n} // namespace detail\n\n'
    printf 'template <class T> concept NobodyTold = true;\n\n/// A word about it.\ntemplate <class T>\n    requires true\nconcept SomebodyTold = true;\n\n'
    printf 'template <class T>\nconcept NobodyToldEither =\n    true;\n} // namespace ansatz\n'
} > "$tree/include/ansatz/world/planted.hpp"
printf '\nSee \\ref nowhere_at_all, and \\image html never_drawn.svg "A picture"\n' >> "$kept"
if "$tree/tools/docs/build" "$scratch/build" > "$scratch/log" 2>&1; then echo "A reference that leads nowhere passes"; exit 1; fi
expect() { grep -qF -e "$1" "$scratch/log" || { printf 'The build should say\n    %s\nbut it says\n%s\n' "$1" "$(head -n 20 "$scratch/log")"; exit 1; }; checked=$((checked + 1)); }
expect "unable to resolve reference to 'nowhere_at_all'"
expect "include/ansatz/world/planted.hpp:14: the concept NobodyTold is not documented"
expect "include/ansatz/world/planted.hpp:22: the concept NobodyToldEither is not documented"
expect "never_drawn.svg"
for name in HiddenAndPlain SomebodyTold; do
    if grep -q "the concept $name is not" "$scratch/log"; then echo "The check asks for documentation of $name"; exit 1; fi
done
if grep '^docs: ' "$scratch/log" | grep -vE 'NobodyTold|never_drawn.svg|a forge shows|pictures are not drawn|[0-9] faults in'; then echo "The check finds more than the two concepts"; exit 1; fi

echo "$checked faults, each found"
