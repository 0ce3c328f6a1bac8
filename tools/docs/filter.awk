# SPDX-License-Identifier: BSL-1.0
#
# What Doxygen reads instead of a file.
#
# - Members that every policy and column has, as its role or its name, are documented once, here.
# - "(notes 1.6.1" in a header becomes a link to the section of its chapter's page, where there is one.
# - A policy with an exercise of its name is linked to it: the exercise's page links back.
# - An exercise's README.md becomes the page exercise_<module>_<name>; links between files become links between pages.

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
}

FNR == 1 {
    header = FILENAME ~ /\.hpp$/
    readme = FILENAME ~ /exercises\/.*README\.md$/
    stem = FILENAME; sub(/.*\//, "", stem); sub(/\.[a-z]+$/, "", stem)
    policy = ""
    m = split(stem, word, "_")
    for (i = 1; i <= m; i++) policy = policy toupper(substr(word[i], 1, 1)) substr(word[i], 2)
    told = ""
}

# "1.6.1" as a link, where its page has that section.
function linked(number,    anchor) {
    anchor = "section_" number
    gsub(/\./, "_", anchor)
    return (anchor in section) ? "\\ref " anchor " \"" number "\"" : number
}

header && match($0, /^\/\/\/.*\(notes [0-9]/) {
    rest = $0; $0 = ""
    if (match(rest, /\(notes [0-9., and]+/)) {
        list = substr(rest, RSTART + 7, RLENGTH - 7)
        $0 = substr(rest, 1, RSTART + 6)
        rest = substr(rest, RSTART + RLENGTH)
        while (match(list, /[0-9]+(\.[0-9]+)+/)) {
            number = substr(list, RSTART, RLENGTH)
            $0 = $0 substr(list, 1, RSTART - 1) linked(number)
            if (told == "") told = number
            list = substr(list, RSTART + RLENGTH)
        }
        $0 = $0 list rest
    } else $0 = rest
}

# The policy that the header is named after: where it is taught, and which exercise asks for it.
header && told != "" && ($0 ~ "^(struct|class) " policy "( |$|\\{)" || $0 ~ "^(inline )?namespace ansatz::" stem " ") {
    print "/// \\par In the course"
    print "/// Section " linked(told) ((stem in exercise) ? ", exercise \\ref " exercise[stem] " \"" stem "\"" : "") "."
    print
    next
}

# Conventional members without a comment of their own.
header && !/\/\/[\/!]/ {
    if (match($0, /^ +using [A-Za-z]+ = /)) { name = $0; sub(/^ +using /, "", name); sub(/ .*/, "", name) }
    else if (match($0, /^ +static constexpr [A-Za-z:_]+ [a-z_]+ = /)) { name = $0; sub(/^ +static constexpr [A-Za-z:_]+ /, "", name); sub(/ .*/, "", name) }
    else if (match($0, /^ +static (constexpr )?void parameters\(/)) name = "parameters"
    else if (match($0, /^ +void check\(\) const/)) name = "check"
    else name = ""
    if (name in said) {
        if (/[{][^}]*$/) { indent = $0; sub(/[^ ].*/, "", indent); print indent "/** " said[name] " */ " substr($0, length(indent) + 1) }
        else if (/\}$/ && name != "parameters" && name != "check") print $0 " ///< " said[name]
        else { indent = $0; sub(/[^ ].*/, "", indent); print indent "/** " said[name] " */ " substr($0, length(indent) + 1) }
        next
    }
}

readme {
    if (FNR == 1) {
        n = split(FILENAME, part, "/")
        print $0 " {#" exercise[part[n - 1]] "}"
        next
    }
    while (match($0, /\[[^]]*\]\([^)]*\)/)) {
        link = substr($0, RSTART, RLENGTH)
        before = substr($0, 1, RSTART - 1); after = substr($0, RSTART + RLENGTH)
        text = link; sub(/^\[/, "", text); sub(/\]\(.*/, "", text); gsub(/`/, "", text)
        target = link; sub(/^.*\]\(/, "", target); sub(/\)$/, "", target); sub(/^.*\//, "", target)
        if (target ~ /^[0-9.]+-.*\.cpp$/) {
            number = target; sub(/-.*/, "", number)
            anchor = "section_" number; gsub(/\./, "_", anchor)
            new = (anchor in section) ? "\\ref " anchor " \"" text "\"" : text
        } else if (link ~ /include\/ansatz\/.*\.hpp/) new = "\\ref " target " \"" text "\""
        else new = "`" text "`"
        $0 = before new after
    }
    print
    next
}

{ print }
