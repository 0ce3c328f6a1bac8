# SPDX-License-Identifier: BSL-1.0
#
# Reads the pages of a site and prints its faults: what asks another host, and links to pages and places that are not there.
#
# usage: cd <the folder with the html> && find . -type f | awk -f links.awk
#
# Its input are the names of all files. It reads the pages, the styles, the pictures, and the lists that the navigation and
# the search are made of; not MathJax, of which only what is wanted is copied, nor the scripts of Doxygen and of the theme.

{ sub(/^\.\//, ""); there[$0] = 1; files[++count] = $0 }

END {
    for (i = 1; i <= count; i++) {
        file = files[i]
        folder = file
        if (!sub(/[^\/]*$/, "", folder)) folder = ""
        if (file ~ /^mathjax\//) continue
        if (file ~ /\.html$/) read_page()
        else if (file ~ /\.(css|svg)$/) read_style()
        else if (file ~ /\.js$/ && file !~ /^(jquery|dynsections|resize|navtree|menu|svgpan|clipboard|cookie|doxygen-awesome.*)\.js$/ && file != "search/search.js") read_list()
    }
    for (link in from) {
        target = link; place = ""
        if ((hash = index(link, "#")) > 0) { target = substr(link, 1, hash - 1); place = substr(link, hash + 1) }
        if (!(target in there)) print "there is no " target ", to which " from[link] " links" others(link)
        # Doxygen 1.9.4 names the section of nested classes in the head of a page, though all of them are private.
        else if (place == "nested-classes" && from[link] == target) continue
        else if (place != "" && target ~ /\.html$/ && !((target "#" place) in places)) print target " has no place '" place "', to which " from[link] " links" others(link)
    }
}

function others(link) { return pages[link] > 1 ? ", and " pages[link] - 1 " more" : "" }

# The value of an attribute of a tag, or nothing.
function attribute(tag, name,    value, quote) {
    if (!match(tag, "[ \t\n]" name "[ \t\n]*=[ \t\n]*[\"']")) return ""
    quote = substr(tag, RSTART + RLENGTH - 1, 1)
    value = substr(tag, RSTART + RLENGTH)
    if (index(value, quote) == 0) return ""
    value = substr(value, 1, index(value, quote) - 1)
    gsub(/&amp;/, "\\&", value)
    gsub(/%20/, " ", value)
    return value
}

# A link as the page writes it, from the folder of that page: kept under its path in the site.
function links_to(link) {
    if (link == "" || link ~ /^(https?|mailto|javascript|data|magnet|file):/ || link ~ /^\/\//) return
    if (link ~ /^[@\\]ref /) { print file " names '" link "', which no page has"; return }
    if (link ~ /^#/) link = file link
    else link = folder link
    sub(/\?[^#]*/, "", link)
    while (sub(/(^|\/)[^\/.][^\/]*\/\.\.\//, "/", link)) sub(/^\//, "", link)
    if (link ~ /#$/) sub(/#$/, "", link)
    if (link in from) { if (last[link] != file) pages[link]++ }
    else { from[link] = file; pages[link] = 1 }
    last[link] = file
}

# What a browser fetches without being asked.
function loads(what) {
    if (what ~ /^(https?:)?\/\//) print file " asks another host: " what
    else links_to(what)
}

function read_page(    tag, name, text, end, n, part, k) {
    RS = "<"
    while ((getline text < file) > 0) {
        end = index(text, ">")
        tag = end > 0 ? substr(text, 1, end - 1) : text
        name = tag; sub(/[ \t\n].*/, "", name); name = tolower(name)
        if (name !~ /^[a-z]/) continue
        if (name == "style" || name == "script") styles(substr(text, end + 1))
        if (name == "script" && substr(text, end + 1) ~ /["'](https?:)?\/\/[a-z0-9]/) print file " has a script that names another host"
        if (tag !~ /=/) continue
        if (index(tag, "id=")) places[file "#" attribute(tag, "id")] = 1
        if (name == "a") { places[file "#" attribute(tag, "name")] = 1; links_to(attribute(tag, "href")) }
        else if (name == "area") links_to(attribute(tag, "href"))
        else if (name == "link" || name == "base" || name == "image" || name == "use") { loads(attribute(tag, "href")); loads(attribute(tag, "xlink:href")) }
        if (index(tag, "src")) loads(attribute(tag, "src"))
        if (index(tag, "srcset=")) {
            n = split(attribute(tag, "srcset"), part, / *, */)
            for (k = 1; k <= n; k++) { sub(/ .*/, "", part[k]); loads(part[k]) }
        }
        if (index(tag, " data=")) loads(attribute(tag, "data"))
        if (index(tag, "poster=")) loads(attribute(tag, "poster"))
        if (index(tag, "action=")) loads(attribute(tag, "action"))
        if (name == "meta" && tolower(tag) ~ /http-equiv=.refresh/) print file " sends the reader on: <" tag ">"
        if (index(tag, "url(")) styles(tag)
    }
    close(file)
    RS = "\n"
}

# Styles: url(...) and @import.
function styles(text,    url) {
    while (match(text, /url\([^)]*\)|@import[ \t]+["'][^"']*["']/)) {
        url = substr(text, RSTART, RLENGTH)
        text = substr(text, RSTART + RLENGTH)
        sub(/^url\( */, "", url); sub(/ *\)$/, "", url); sub(/^@import[ \t]+/, "", url); gsub(/["']|&quot;/, "", url)
        if (url ~ /^(https?:)?\/\//) print file " asks another host: " url
    }
}

function read_style(    text) {
    while ((getline text < file) > 0) {
        styles(text)
        if (file ~ /\.svg$/ && match(text, /<(image|use|script|style)[^>]*(href|src)="(https?:)?\/\/[^"]*"/)) print file " asks another host: " substr(text, RSTART, RLENGTH)
    }
    close(file)
}

# Strings that are pages: "world_8hpp.html#a1", '../world_8hpp.html'; and references of the navigation that lead nowhere.
# navtreeindex*.js is no list of links but of where in the tree a page stands. In the tree's branches (world_8hpp.js) Doxygen
# names places by the header, though it describes a member of a namespace on the page of that namespace: only pages count;
# and so in the list NAVTREEINDEX, which repeats one in some hundred of those.
function read_list(    text, link, branches) {
    if (file ~ /^navtreeindex[0-9]*\.js$/) return
    branches = folder == "" && file !~ /^(navtreedata|menudata)\.js$/
    while ((getline text < file) > 0) {
        if (text ~ /^var NAVTREEINDEX/) branches = 1
        if (index(text, ".html") == 0 && index(text, "ref ") == 0) continue
        while (match(text, /["']([^"' ]*\.html(#[^"' ]*)?|[@\\]ref [^"']*)["']/)) {
            link = substr(text, RSTART + 1, RLENGTH - 2)
            text = substr(text, RSTART + RLENGTH)
            if (branches) sub(/#.*/, "", link)
            links_to(link)
        }
    }
    close(file)
}
