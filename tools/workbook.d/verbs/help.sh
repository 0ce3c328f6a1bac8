# shellcheck shell=bash
# SPDX-License-Identifier: BSL-1.0
#
# what the verbs are, or how one of them is used
#
#   ./workbook help               all verbs
#   ./workbook help costs         one of them; ./workbook costs --help says the same

verb_help() {
    local verb
    if [ $# -gt 1 ]; then complain "help takes one verb; what is '$2'?"; return 2; fi
    if [ $# -gt 0 ]; then
        verb=$1
        if [ ! -f "$ROOT/tools/workbook.d/verbs/${verb##*/}.sh" ]; then
            complain "there is no verb '$verb'$(did_you_mean "$verb" "$(verbs)")"
            return 2
        fi
        help_of "${verb##*/}" | reflowed
        echo
        say "With every verb: --help (-h) shows its help, --yes (-y) answers yes where something would be installed."
        return 0
    fi
    heading "./workbook [verb] [arguments]"
    say "The one command of Ansatz. Without a verb it takes the tour of the course. --yes answers yes where something would be installed."
    echo
    for verb in $(verbs); do
        printf '  %s%s%s  ' "$BOLD" "$(fit "$verb" 9)" "$PLAIN"
        beside 13 "$(help_of "$verb" | head -n 1)"
    done
    echo
    echo "./workbook help <verb> says more."
    say "An update (git pull) that stops at a file which you edited: git stash, git pull, git stash pop. Or ./workbook reset <name>, which puts your answer aside."
}

# A verb's help as wide as the terminal: paragraphs, and examples (indented), whose words stay in their column.
reflowed() {
    awk -v width="$((WIDTH > 100 ? 100 : WIDTH))" '
        function blanks(n,    s) { while (n-- > 0) s = s " "; return s }
        function put(line, text, column,    n, i, word, words) {
            n = split(text, word, " ")
            for (i = 1; i <= n; i++) {
                if (words && length(line) + 1 + length(word[i]) > width) { print line; line = blanks(column); words = 0 }
                line = line (words++ ? " " : "") word[i]
            }
            print line
        }
        function end() { if (text != "") put("", text, 0); text = "" }
        /^ / {
            end()
            if (length($0) <= width) { print; next }
            match($0, /^ */)
            indent = RLENGTH
            if (!match(substr($0, indent + 1), /  +/)) { put(blanks(indent), $0, indent + 4); next }
            left = indent + RSTART - 1
            column = left + RLENGTH
            if (column <= width - 24) put(substr($0, 1, column), substr($0, column), column)
            else { print substr($0, 1, left); put(blanks(indent + 4), substr($0, column), indent + 4) }
            next
        }
        /^$/ { end(); print; next }
        { text = text " " $0 }
        END { end() }'
}
