# SPDX-License-Identifier: BSL-1.0
#
# Prints the faults of the formulas in texts and in the comments of headers: what would stay as TeX on the page ($x$, a \f$
# without its end), and what MathJax does not understand (an unknown command, a brace that is open).
#
# usage: awk -v mathjax="<the scripts of MathJax that read TeX>" -f formulas.awk <texts and headers>

BEGIN {
    # A command is known if one of these scripts has an entry of its name.
    n = split(mathjax, script, " ")
    for (i = 1; i <= n; i++) {
        while ((getline line < script[i]) > 0)
            while (match(line, /[{,]"?\\*[A-Za-z]+"?:/)) {
                name = substr(line, RSTART + 1, RLENGTH - 2)
                gsub(/["\\]/, "", name)
                known[name] = 1
                line = substr(line, RSTART + RLENGTH - 1)
            }
        close(script[i])
    }
    split("begin end left right", given, " ")
    for (i in given) known[given[i]] = 1
}

FNR == 1 { finish(); file = FILENAME; header = file ~ /\.hpp$/; fenced = 0 }
{ line = $0 }
header { if (line !~ /\/\/\/|\\f[$\[\]]/) { finish(); next } sub(/^.*\/\/\/<?/, "", line) }
!header && line ~ /^ *(```|~~~)/ { fenced = !fenced; next }
fenced { next }
# A formula may go over several lines, but over no empty one.
line ~ /^ *$/ { finish(); next }
{ gsub(/`[^`]*`/, "", line); if (text == "") first = FNR; text = text line "\n" }
END { finish() }

function fault(what) { print file ":" first ": " what }

# A paragraph: formula by formula.
function finish(    formula, start, close_by, at) {
    while ((start = match(text, /\\f[$\[]/)) > 0) {
        close_by = substr(text, start + 2, 1) == "$" ? "\\f$" : "\\f]"
        formula = substr(text, start + 3)
        text = substr(text, 1, start - 1) " "
        at = index(formula, close_by)
        if (at == 0) { fault("a formula has no end: " shown(formula)); text = ""; return }
        text = text substr(formula, at + 3)
        look_at(substr(formula, 1, at - 1))
    }
    if (text ~ /\\f[\]$]/) fault("a formula has no beginning")
    if (match(text, /\$[^$ \n][^$\n]*\$|\$\$/)) fault("a formula would stay as TeX, write \\f$...\\f$: " shown(substr(text, RSTART)))
    text = ""
}
function shown(formula) { sub(/\n.*/, "", formula); return substr(formula, 1, 60) }

function look_at(formula,    whole, open, i, c, name) {
    whole = shown(formula)
    for (i = 1; i <= length(formula); i++) {
        c = substr(formula, i, 1)
        if (c == "\\") {
            name = substr(formula, i + 1)
            if (match(name, /^[A-Za-z]+/)) {
                name = substr(name, 1, RLENGTH)
                if (!(name in known)) fault("MathJax knows no \\" name ": " whole)
                i += RLENGTH
            } else i++
        } else if (c == "{") open++
        else if (c == "}" && --open < 0) break
    }
    if (open != 0) fault("a brace has no partner: " whole)
}
