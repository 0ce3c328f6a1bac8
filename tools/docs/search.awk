# SPDX-License-Identifier: BSL-1.0
#
# Adds the sections of the chapters and the exercises to the site's search, by every word of their titles: Doxygen's own
# finds types and pages alone, and those by their first letters only.
#
# usage: awk -v search=<the site's folder search> -f search.awk docs/site/aliases.txt docs/*.md <the page of exercises>

BEGIN {
    quote = sprintf("%c", 39)
    n = split("and the for of in to as what how from with its is it an not by on at or", word, " ")
    for (i = 1; i <= n; i++) says_nothing[word[i]] = 1
    # all_<n>.js holds what begins with the n-th of these letters.
    while ((getline line < (search "/searchdata.js")) > 0)
        if (line ~ /^ *0: "/) { letters = line; sub(/^ *0: "/, "", letters); sub(/".*/, "", letters); break }
}

# Each word of `text` finds `url`, which is shown as `title`.
function found_by(text, url, title,    list, n, i, key) {
    gsub(quote, "", text); gsub(quote, "", title)
    n = split(tolower(text), list, /[^a-z0-9.]+/)
    for (i = 1; i <= n; i++) {
        key = list[i]; sub(/\.$/, "", key)
        if (length(key) < 2 || (key in says_nothing) || ((key, url) in known)) continue
        known[key, url] = 1
        targets[key] = targets[key] ",[" quote "../" url quote ",1," quote title quote "]"
    }
}

FNR == 1 { chapter = "" }
FILENAME ~ /aliases\.txt$/ { if ($0 !~ /^#/) { section = $1; sub(/^[^ ]+ */, ""); alias[section] = $0 } next }
/^# .*\{#chapter_/ { chapter = $0; sub(/^.*\{#/, "", chapter); sub(/\}.*/, "", chapter); next }
chapter != "" && /^##+ .*\{#section_/ {
    label = $0; sub(/^.*\{#/, "", label); sub(/\}.*/, "", label)
    title = $0; sub(/^#+ */, "", title); sub(/ *\{#.*/, "", title); gsub(/[`*"\\]/, "", title)
    number = title; sub(/ .*/, "", number)
    found_by(title " " alias[number], chapter ".html#" label, title)
}
match($0, /^\| [0-9.]+ \| \\ref exercise_[a-z0-9_]+ "[^"]*"/) {
    split($0, cell, "|")
    number = cell[2]; gsub(/ /, "", number)
    label = cell[3]; sub(/^ *\\ref /, "", label); sub(/ .*/, "", label)
    title = cell[3]; sub(/^[^"]*"/, "", title); sub(/".*/, "", title)
    found_by("exercise " number " " title, label ".html", "Exercise " number ": " title)
}

# The index writes a full stop as _2e.
function id_of(word) { gsub(/\./, "_2e", word); return word "_topics" }

END {
    for (key in targets) {
        place = index(letters, substr(key, 1, 1))
        if (place == 0) continue
        file = sprintf("%s/all_%x.js", search, place - 1)
        entries[file] = entries[file] ",\n  [" quote id_of(key) quote ",[" quote key " (course)" quote targets[key] "]]"
    }
    for (file in entries) {
        text = ""
        while ((getline line < file) > 0) text = text line "\n"
        close(file)
        sub(/\n\];\n*$/, "", text)
        printf "%s%s\n];\n", text, entries[file] > file
        close(file)
    }
}
