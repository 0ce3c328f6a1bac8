# SPDX-License-Identifier: BSL-1.0
#
# What Doxygen reads instead of a file.
#
# - Members that every policy and column has, as its role or its name, are documented once, here.
# - "(notes 1.6.1" in a header becomes a link to the section of its chapter's page, where there is one.
# - The page of a policy tells what its header tells (when to use it and when not), where it is taught, and which exercise
#   asks for it: the exercise's page links back.
# - An exercise's README.md becomes the page exercise_<module>_<name>.
# - On text pages, links between files become links between pages, `Drag` a link to Drag, and a long page begins with its
#   contents.

BEGIN {
    said["role"] = "the role that it has in a world"
    said["reads"] = "the columns that it reads"
    said["writes"] = "the columns that it changes"
    said["scratch"] = "the columns that it needs for its stages, where bodies are coupled"
    said["place"] = "where in the step it acts"
    said["name"] = "its name in sentences"
    said["parameters"] = "every parameter with its name, for those that read, print, save or hash them"
    said["check"] = "refuses parameters out of their range: std::invalid_argument with name, value and range"
    said["stages"] = "how often a step asks the forces"
    said["order"] = "its order of accuracy: the error of a run falls with dt to this power"
    said["reversible"] = "whether it runs backwards when the velocity is turned round"
    said["needs_jacobian"] = "it asks the forces for their derivatives"
    said["couples_bodies"] = "it acts between bodies, so that no body can be computed alone"
    said["Unit"] = "the unit of its entries"
    said["shape"] = "a number or a vector for each body"
    said["Scalar"] = "the number type"
    # Of paths, and of property maps and iterators in the manner of Boost.
    said["bind"] = "the estimate for one graph and goal: a function of a vertex"
    said["default_heuristic"] = "the heuristic of a search that names none"
    said["default_cost"] = "the number that a search counts in unless it is told otherwise"
    said["updates"] = "whether a closed node gets the cheaper g and parent"
    said["reopens"] = "whether it goes back to the open list"
    said["resumable"] = "whether a search can be left and taken up again"
    said["key_type"] = "what is looked up"
    said["value_type"] = "what is found"
    said["reference"] = "how it is handed out"
    said["category"] = "what a property map of Boost is: readable"
    said["iterator_category"] = "what an iterator is"
    said["difference_type"] = "between two iterators"
    said["pointer"] = "to what is found"
    # The functions that make a class a graph of Boost.Graph, a property map or an iterator.
    of_boost["out_edges"] = "the edges that lead out of a vertex, as two iterators"
    of_boost["out_degree"] = "how many edges lead out of a vertex"
    of_boost["source"] = "the vertex that an edge leaves"
    of_boost["target"] = "the vertex that an edge leads to"
    of_boost["vertices"] = "all vertices, as two iterators"
    of_boost["num_vertices"] = "how many vertices there are"
    of_boost["get"] = "a property map of a graph, or what it holds"
    of_boost["edge_weights"] = "the weights in the number of a search"
    of_boost["has_vertex"] = "whether there is this vertex"
    of_boost["is_passable"] = "the flag of a vertex or edge"
    of_boost["is_blocked"] = "whether a vertex can be no start and no goal"
    of_boost["name_of"] = "its name in sentences"
    of_boost["size_in_words"] = "how large the graph is, for sentences"
    of_boost["position_of"] = "where a vertex is"
    of_boost["least_cost_per_metre"] = "what a metre costs at least"
    of_boost["operator=="] = "whether both are the same"
    of_boost["operator++"] = "on to the next"
    of_boost["operator*"] = "what it points to"

    # The sections that have an anchor, and the exercises that there are: asked of the shell once for each file.
    command = "grep -ohE '\\{#section_[0-9_]+\\}' docs/*.md 2>/dev/null"
    while ((command | getline line) > 0) { gsub(/[{}#]/, "", line); section[line] = 1 }
    close(command)
    command = "ls -d exercises/*/*/ 2>/dev/null"
    while ((command | getline line) > 0) {
        n = split(line, part, "/")                       # exercises, 1-motion, drag, ""
        module = part[2]; sub(/^[0-9]+-/, "", module)
        exercise[part[3]] = "exercise_" module "_" part[3]
    }
    close(command)
    # What headers are named after: World of world.hpp.
    command = "grep -rE '^(template <.*> *)?(struct|class) [A-Z][A-Za-z0-9]*( |$|\\{)' include/ansatz 2>/dev/null"
    while ((command | getline line) > 0) {
        file = line; sub(/:.*/, "", file); name = line; sub(/^.*(struct|class) /, "", name); sub(/[^A-Za-z0-9].*/, "", name)
        if (line !~ /; *$/ && policy_of(stem_of(file)) == name) named[name] = file
    }
    close(command)
    # And the namespace that a header opens first, where it is not ansatz itself.
    command = "grep -rE '^namespace ansatz::[a-z_]+ \\{' include/ansatz 2>/dev/null"
    while ((command | getline line) > 0) {
        file = line; sub(/:.*/, "", file); space = line; sub(/^.*namespace /, "", space); sub(/ .*/, "", space)
        if (!(file in opens)) opens[file] = space
    }
    close(command)
}

FNR == 1 {
    header = FILENAME ~ /\.hpp$/
    readme = FILENAME ~ /exercises\/.*README\.md$/
    text_page = FILENAME ~ /\.md$/ && FILENAME !~ /\/pages\/[^\/]*\.md$/
    fenced = 0
    # Doxygen names files by their whole path: from the project's folder on, links can be followed.
    folder = FILENAME
    if (ENVIRON["PWD"] != "" && index(folder, ENVIRON["PWD"] "/") == 1) folder = substr(folder, length(ENVIRON["PWD"]) + 2)
    sub(/[^\/]*$/, "", folder)
    stem = stem_of(FILENAME)
    policy = policy_of(stem)
    hidden_until = ""; told = ""; telling = 0; tale = ""; opening = ""; paragraph = 0; comment_of_its_own = ""
}

# "explicit_euler" of a path, and "ExplicitEuler" of that.
function stem_of(file) { sub(/.*\//, "", file); sub(/\.[a-z]+$/, "", file); return file }
function policy_of(stem,    word, m, i, name) {
    m = split(stem, word, "_")
    for (i = 1; i <= m; i++) name = name toupper(substr(word[i], 1, 1)) substr(word[i], 2)
    return name
}

# "1.6.1" as a link, where its page has that section.
function linked(number,    anchor) {
    anchor = "section_" number
    gsub(/\./, "_", anchor)
    return (anchor in section) ? "\\ref " anchor " \"" number "\"" : number
}

function with_sections(text,    done, list, number) {
    if (!match(text, /\(notes [0-9., and]+/)) return text
    list = substr(text, RSTART + 7, RLENGTH - 7)
    done = substr(text, 1, RSTART + 6)
    text = substr(text, RSTART + RLENGTH)
    while (match(list, /[0-9]+(\.[0-9]+)+/)) {
        number = substr(list, RSTART, RLENGTH)
        done = done substr(list, 1, RSTART - 1) linked(number)
        if (told == "") told = number
        list = substr(list, RSTART + RLENGTH)
    }
    return done list text
}
header && /^\/\/\// { $0 = with_sections($0) }
# Doxygen finds no name from within a concept.
header && (stem == "concepts" || stem == "broadphase" || stem == "inside" || stem == "shapes") && /^\/\/\/ / { $0 = with_names($0) }
FILENAME ~ /\/pages\/library\.md$/ { print with_sections($0); next }

# What the header tells, kept for the page of its policy.
header && /^\/\/\/ \\file/ { telling = 1; print; next }
telling && /^\/\/\// {
    if ($0 ~ /^\/\/\/ *$/ && paragraph == 0) paragraph = 1
    if (paragraph == 0) opening = opening $0 "\n"
    else tale = tale $0 "\n"
}
# A remark between the lines of the comment would end it.
telling && /^\/\/( |$)/ { print "///"; next }
telling && !/^\/\/\// { telling = 0; say_where_taught() }
# A comment that begins with a command has no first sentence of its own.
!telling && /^\/\/\// { if (comment_of_its_own == "") comment_of_its_own = $0 }

function say_where_taught() {
    if (told == "" && !(stem in exercise)) return
    print "/// \\par In the course"
    print "/// " (told != "" ? "Section " linked(told) : "The") ((stem in exercise) ? (told != "" ? "," : "") " exercise \\ref " exercise[stem] " \"" stem "\"" : "") "."
}

# The policy that the header is named after: what the header tells, where it is taught, and which exercise asks for it.
header && opening != "" && !telling && (($0 ~ "^(template <.*> *)?(struct|class) " policy "( |$|\\{)" && $0 !~ /;$/) || $0 ~ "^(inline )?namespace ansatz::" stem " ") {
    if (comment_of_its_own ~ /^\/\/\/ [\\@][tp]/) { sub(/^\/\/\/ /, "/// \\brief ", opening); printf "///\n%s%s", opening, tale }
    else if (comment_of_its_own != "" && comment_of_its_own !~ /\\f[$\[]/) printf "%s", tale
    else printf "///\n%s%s", opening, tale
    say_where_taught()
    print
    opening = ""; comment_of_its_own = ""
    next
}
!/^\/\/\// && !/^(template|    requires)/ { comment_of_its_own = "" }

# What a policy is inside a world, `In<S>`, belongs to the step; concepts.hpp says what it must have.
header && /^ +(template <[^>]*> *)?struct In \{/ && !/\};/ { indent = $0; sub(/[^ ].*/, "", indent); print "/** \\cond */ " $0; hidden_until = indent "};"; next }
hidden_until != "" && $0 == hidden_until { print $0 " /** \\endcond */"; hidden_until = ""; next }

# Functions of Boost's concepts without a comment of their own: free ones, friends, and operators of iterators.
{ behind_a_comment = before_this ~ /^ *(\/\/\/|\*\/|template <.*> *$)/; before_this = $0 }
header && !behind_a_comment && !/\/\/[\/!]/ && /^([a-zA-Z[]|    friend |    \[\[gnu::always_inline\]\] |    [A-Z][A-Za-z]*&? operator)/ && match($0, /(^|[ &])([a-z_]+|operator(==|\+\+|\*))\([^;]*\{/) {
    name = substr($0, RSTART, RLENGTH); sub(/^[ &]/, "", name); sub(/\(.*/, "", name)
    if (name in of_boost) { indent = $0; sub(/[^ ].*/, "", indent); print indent "/** " of_boost[name] " */ " substr($0, length(indent) + 1); next }
}
# Conventional members without a comment of their own.
header && !/\/\/[\/!]/ {
    if (match($0, /^ +using [A-Za-z_]+ = /)) { name = $0; sub(/^ +using /, "", name); sub(/ .*/, "", name) }
    else if (match($0, /^ +static constexpr [A-Za-z:_]+ [a-z_]+ = /)) { name = $0; sub(/^ +static constexpr [A-Za-z:_]+ /, "", name); sub(/ .*/, "", name) }
    else if (match($0, /^ +static (constexpr )?void parameters\(/)) name = "parameters"
    else if (match($0, /^ +void check\(\) const/)) name = "check"
    else if (match($0, /^ +template <class Cost, class Graph> auto bind\(/)) name = "bind"
    else if (match($0, /^ +template <class Cost, class Graph>$/)) name = "bind"
    else name = ""
    if (name in said) {
        if (/[{][^}]*$/) { indent = $0; sub(/[^ ].*/, "", indent); print indent "/** " said[name] " */ " substr($0, length(indent) + 1) }
        else if (/\}$/ && name != "parameters" && name != "check") print $0 " ///< " said[name]
        else { indent = $0; sub(/[^ ].*/, "", indent); print indent "/** " said[name] " */ " substr($0, length(indent) + 1) }
        next
    }
}

# The label of a page, from the first heading of its file that has one.
function label_of(file,    line, label) {
    if (file in labels) return labels[file]
    label = ""
    while (label == "" && (getline line < file) > 0)
        if (line ~ /^# .*\{#[A-Za-z0-9_]+\} *$/) { label = line; sub(/^.*\{#/, "", label); sub(/\} *$/, "", label) }
    close(file)
    labels[file] = label
    return label
}

# A path without "folder/..".
function plain_path(path) {
    while (sub(/[^\/.][^\/]*\/\.\.\//, "", path)) ;
    gsub(/\/\.\//, "/", path); sub(/^\.\//, "", path); sub(/\/$/, "", path)
    return path
}

# What a link of a text page to a file of the project becomes on the site.
function link_of(text, target,    bare, path, part, n, label, name) {
    if (target ~ /^(https?:|mailto:|#|@ref|\\ref)/) return "[" text "](" target ")"
    bare = text; gsub(/`/, "", bare)
    path = plain_path(folder target)
    n = split(path, part, "/")
    name = part[n]
    if (path == "LICENSE") return "<a href=\"LICENSE.txt\">" bare "</a>"
    if (path == "README.md") return "\\ref index \"" bare "\""
    if (path ~ /^(docs\/)?[^\/]*\.md$/ && (label = label_of(path)) != "") return "\\ref " label " \"" bare "\""
    if (path ~ /\.md$/ && path !~ /^exercises\//) return "[" text "](" path ")"
    if (path ~ /^include\/.*\.hpp$/) { sub(/^include\//, "", path); return "\\ref " path " \"" bare "\"" }
    if (path ~ /^exercises\// && n >= 3 && (n == 3 || name == "README.md") && (part[3] in exercise)) return "\\ref " exercise[part[3]] " \"" bare "\""
    if (path ~ /^exercises(\/[^\/]*)?$/) return "\\ref page_exercises \"" bare "\""
    if (path ~ /^chapters(\/[^\/]*)?$/) {
        sub(/^[0-9]+-/, "", name)
        return "\\ref " (label_of("docs/" name ".md") != "" && n == 2 ? label_of("docs/" name ".md") : "page_programs") " \"" bare "\""
    }
    if (path ~ /^chapters\/[^\/]*\/[^\/]*\.[ch]pp$/) {
        # The name that tools/docs/build gives to a program's page.
        sub(/^[0-9]+-/, "", part[2])
        label = name; sub(/\.[ch]pp$/, "", label); gsub(/[^A-Za-z0-9]/, "_", label)
        return "\\ref program_" part[2] "_" label (name ~ /\.hpp$/ ? "_hpp" : "") " \"" bare "\""
    }
    return "`" bare "`"
}

function with_links(text,    done, link, target, before) {
    done = ""
    while (match(text, /\[[^]]*\]\([^)]*\)/)) {
        before = substr(text, 1, RSTART - 1)
        link = substr(text, RSTART, RLENGTH)
        text = substr(text, RSTART + RLENGTH)
        if (before ~ /!$/) { done = done before link; continue }      # a picture
        target = link; sub(/^.*\]\(/, "", target); sub(/\)$/, "", target)
        sub(/^\[/, "", link); sub(/\]\(.*/, "", link)
        done = done before link_of(link, target)
    }
    return done text
}

# `Drag` as a link.
function with_names(text,    done, name) {
    done = ""
    while (match(text, /`[^`]+`/)) {
        name = substr(text, RSTART + 1, RLENGTH - 2)
        done = done substr(text, 1, RSTART - 1) ((name in named) ? "<code>\\ref " ((named[name] in opens) ? opens[named[name]] : "ansatz") "::" name " \"" name "\"</code>" : "`" name "`")
        text = substr(text, RSTART + RLENGTH)
    }
    return done text
}

# A long page begins with its contents.
function is_long(file,    line, count) {
    count = 0
    while ((getline line < file) > 0) {
        if (line ~ /^## /) count++
        if (line ~ /\[TOC\]|[\\@]tableofcontents/) count = -1000
    }
    close(file)
    return count > 2
}
text_page && !readme && FNR == 1 && FILENAME ~ /docs\/[^\/]*\.md$/ && /^# / && is_long(FILENAME) {
    print
    print ""
    print "[TOC]"
    next
}

# "Notes 1.7" in an exercise leads to the section.
readme && FNR == 1 {
    n = split(FILENAME, part, "/")
    title = $0
    if (match(title, /^# [0-9.]+ /)) title = "# Exercise " substr(title, 3, RLENGTH - 3) ": " substr(title, RLENGTH + 1)
    print title " {#" exercise[part[n - 1]] "}"
    printf "\n`./workbook exercise %s` builds and tests your answer, which you write in `exercises/%s/%s/exercise.hpp`.\n", part[n - 1], part[n - 2], part[n - 1]
    next
}
text_page && /^ *(```|~~~)/ { fenced = !fenced }
text_page && !fenced {
    if (readme && match($0, /[Nn]otes [0-9]+(\.[0-9]+)*/)) {
        number = substr($0, RSTART + 6, RLENGTH - 6)
        $0 = substr($0, 1, RSTART + 5) linked(number) substr($0, RSTART + RLENGTH)
    }
    print (/^#/ ? $0 : with_names(with_links($0)))
    next
}

{ print }
