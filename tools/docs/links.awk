# SPDX-License-Identifier: BSL-1.0
#
# Reads the pages of a site and prints its faults: what asks another host, and links to pages and places that are not there.
#
# usage: cd <the folder with the html> && find . -type f | awk -f links.awk
#
# Its input are the names of all files. It reads the pages, the styles, the pictures, the scripts, and the lists that the
# navigation and the search are made of; not MathJax, of which only what is wanted is copied. The scripts of Doxygen and of
# the theme are known by their names: they hold addresses, and ask nobody.

{ sub(/^\.\//, ""); there[$0] = 1; files[++count] = $0 }

END {
    for (i = 1; i <= count; i++) {
        file = files[i]
        folder = file
        if (!sub(/[^\/]*$/, "", folder)) folder = ""
        if (file ~ /^mathjax\//) continue
        if (file ~ /\.html$/) read_page()
        else if (file ~ /\.svg$/) read_page()
        else if (file ~ /\.css$/) styles(whole(file))
        else if (file ~ /\.js$/ && file !~ /^(jquery|dynsections|resize|navtree|menu|svgpan|clipboard|cookie|doxygen-awesome-(darkmode-toggle|fragment-copy-button|interactive-toc|paragraph-link))\.js$/ && file != "search/search.js") { script(whole(file)); read_list() }
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

# A file as one text.
function whole(file,    line, text) {
    while ((getline line < file) > 0) text = text line "\n"
    close(file)
    return text
}

# The value of an attribute of a tag, in quotes or without, or nothing.
function attribute(tag, name,    value, quote) {
    if (!match(tolower(tag), "[ \t\n\"'/]" name "[ \t\n]*=[ \t\n]*")) return ""
    value = substr(tag, RSTART + RLENGTH)
    quote = substr(value, 1, 1)
    if (quote == "\"" || quote == "'") {
        value = substr(value, 2)
        if (index(value, quote) == 0) return ""
        value = substr(value, 1, index(value, quote) - 1)
    } else sub(/[ \t\n].*/, "", value)
    gsub(/&amp;/, "\\&", value)
    gsub(/%20/, " ", value)
    return value
}

# A link as the page writes it, from the folder of that page: kept under its path in the site.
function links_to(link) {
    if (link == "" || tolower(link) ~ /^(https?|mailto|javascript|data|magnet|file):/ || link ~ /^\/\//) return
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

function is_elsewhere(link) { return tolower(link) ~ /^(https?:)?\/\// }

# What a browser fetches without being asked.
function loads(what) {
    if (is_elsewhere(what)) print file " asks another host: " what
    else links_to(what)
}

# Pages, and pictures of lines, which have tags as well.
function read_page(    text, end) {
    RS = "<"
    while ((getline text < file) > 0) {
        end = index(text, ">")
        read_tag(end > 0 ? substr(text, 1, end - 1) : text, end > 0 ? substr(text, end + 1) : "")
    }
    close(file)
    RS = "\n"
}

function read_tag(tag, content,    name, small, n, part, k) {
    name = tag; sub(/[ \t\n\/].*/, "", name); name = tolower(name)
    if (name !~ /^[a-z]/) return
    if (name == "style") styles(content)
    if (name == "script") script(content)
    if (tag !~ /=/) return
    small = tolower(tag)
    # A page within the tag, in place of its src.
    if (index(small, "srcdoc")) {
        if (tolower(attribute(tag, "srcdoc")) ~ /(https?:)?\/\/[a-z0-9]/) print file " has a page within that names another host"
        return
    }
    if (index(small, "id")) places[file "#" attribute(tag, "id")] = 1
    if (name == "a") { places[file "#" attribute(tag, "name")] = 1; links_to(attribute(tag, "href")) }
    else if (name == "area") links_to(attribute(tag, "href"))
    else if (name ~ /^(link|base|image|use|feimage|script)$/) { loads(attribute(tag, "href")); loads(attribute(tag, "xlink:href")) }
    if (index(small, "src")) loads(attribute(tag, "src"))
    if (index(small, "srcset")) {
        n = split(attribute(tag, "srcset"), part, / *, */)
        for (k = 1; k <= n; k++) { sub(/ .*/, "", part[k]); loads(part[k]) }
    }
    if (name == "object") loads(attribute(tag, "data"))
    if (index(small, "poster")) loads(attribute(tag, "poster"))
    if (index(small, "action")) loads(attribute(tag, "action"))
    if (name == "meta" && small ~ /http-equiv=.?refresh/) print file " sends the reader on: <" tag ">"
    if (small ~ /url\(|image-set\(/) styles(tag)
}

# Styles: url(...), @import and the strings of image-set(...), wherever the line is broken.
function styles(text,    small, url) {
    gsub(/&quot;/, "\"", text)
    small = tolower(text)
    while (match(small, /url\([^)]*\)|@import[ \t\n]+["'][^"']*["']|image-set\([ \t\n]*["'][^"']*["']/)) {
        url = substr(text, RSTART, RLENGTH)
        text = substr(text, RSTART + RLENGTH)
        small = substr(small, RSTART + RLENGTH)
        sub(/^[^("']*[("' \t\n]+/, "", url); gsub(/["' \t\n)]/, "", url)
        if (is_elsewhere(url)) print file " asks another host: " url
    }
}

# A script that names another host, or that could ask one by a name put together.
function script(text) {
    if (tolower(text) ~ /["'`](https?:)?\/\/[a-z0-9]/) print file " has a script that names another host"
    else if (text ~ /(^|[^A-Za-z_.])(fetch|importScripts|import) *\(|XMLHttpRequest|WebSocket|EventSource|sendBeacon/) print file " has a script that asks for something"
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
