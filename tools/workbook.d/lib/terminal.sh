# shellcheck shell=bash
# SPDX-License-Identifier: BSL-1.0
#
# Talking to a person: colours only where one looks, lines cut to the width, one line of progress.

if [ -t 1 ] && [ -z "${NO_COLOR:-}" ] && [ "${TERM:-dumb}" != dumb ]; then
    BOLD=$'\033[1m' DIM=$'\033[2m' RED=$'\033[31m' GREEN=$'\033[32m' YELLOW=$'\033[33m' PLAIN=$'\033[0m'
else
    BOLD='' DIM='' RED='' GREEN='' YELLOW='' PLAIN=''
fi
export BOLD DIM RED GREEN YELLOW PLAIN
LIVE=false
[ -t 1 ] && [ "${TERM:-dumb}" != dumb ] && LIVE=true

# The width of the terminal; 80 where there is none.
columns() {
    local width=${COLUMNS:-}
    if [ -z "$width" ] && [ -t 1 ]; then width=$(tput cols 2>/dev/null); fi
    case $width in '' | *[!0-9]* | 0* | ?????*) width=80 ;; esac       # nobody's terminal has 10000
    echo "$width"
}
WIDTH=$(columns)

# A paragraph, wrapped at words.
say() {
    local width=$WIDTH
    [ "$width" -gt 100 ] && width=100
    printf '%s\n' "$*" | fold -s -w "$width" | sed 's/ *$//'
}
# The same to the right of what was printed on the line; further lines begin below it. beside <columns to the left> <text>
beside() {
    local left=$1 width blanks
    shift
    width=$((WIDTH - left))
    [ "$width" -lt 12 ] && width=12
    blanks=$(printf '%*s' "$left" '')
    printf '%s\n' "$*" | fold -s -w "$width" | sed "s/ *\$//; 2,\$s/^/$blanks/"
}
heading() { printf '%s%s%s\n' "$BOLD" "$*" "$PLAIN"; }
complain() { clear_progress; printf '%sworkbook: %s%s\n' "$RED" "$*" "$PLAIN" >&2; }

# Text cut or filled to a number of characters (printf counts bytes).
fit() {
    local text=$1 width=$2
    if [ "${#text}" -gt "$width" ]; then
        if [ "$width" -gt 1 ]; then text="${text:0:$((width - 1))}…"; else text=${text:0:$width}; fi
    fi
    printf '%s%*s' "$text" $((width - ${#text})) ''
}

# One line that overwrites itself. Where nobody watches there is none: logs stay readable.
progress() {
    $LIVE || return 0
    local text=$*
    [ "${#text}" -ge "$WIDTH" ] && text=${text:0:$((WIDTH - 1))}
    printf '\r\033[K%s' "$text"
}
clear_progress() { if $LIVE; then printf '\r\033[K'; fi; }

# Milliseconds of the clock, a duration for people, and a place where durations are remembered.
now() {
    if [ -n "${EPOCHREALTIME:-}" ]; then echo $((${EPOCHREALTIME/[.,]/} / 1000)); else echo $(($(date +%s) * 1000)); fi
}
about() { # the same of a duration that is a guess
    if [ "$1" -lt 90000 ]; then printf '%d s' $((($1 + 500) / 1000)); else printf '%d min' $((($1 + 30000) / 60000)); fi
}
duration() {
    local ms=$1
    if [ "$ms" -lt 60000 ]; then printf '%d.%d s' $((ms / 1000)) $((ms % 1000 / 100))
    else printf '%d min %02d s' $((ms / 60000)) $((ms / 1000 % 60)); fi
}
remember() {
    { mkdir -p build/logs && printf '%s\t%s\t%s\n' "$1" "$2" "$(date '+%Y-%m-%d %H:%M')" >> build/logs/durations.tsv; } 2> /dev/null
    return 0     # no verdict hangs on it
}
last_duration() {
    [ -f build/logs/durations.tsv ] || return 1
    awk -F '\t' -v what="$1" '$1 == what { last = $2 } END { if (last == "") exit 1; print last }' build/logs/durations.tsv
}

# Ctrl-C: every result is written beside its place and moved there whole, so nothing is left to repair. It is said to
# descriptor 9, what the error stream was at the beginning: that of the command which was stopped may go nowhere.
exec 9>&2
stopped() {
    trap - INT TERM
    if declare -F end_running > /dev/null; then end_running; fi
    clear_progress
    printf '\n%s\n' "stopped; nothing is left half done, and the same command goes on from here" >&9
    exit 130
}

# The names of the verbs, one a line, and the first lines of their comments.
verbs() {
    local file
    for file in "$ROOT"/tools/workbook.d/verbs/*.sh; do
        file=${file##*/}
        echo "${file%.sh}"
    done
}
# The comment at the head of a verb's file, without the shell's and the licence's lines.
help_of() {
    awk '/^# (shellcheck|SPDX)/ { next } /^#$/ && !said { next } /^#/ { said = 1; sub(/^# ?/, ""); print; next } { exit }' "$ROOT/tools/workbook.d/verbs/$1.sh"
}

# Of some names (one a line) those that look like a word: equal beginnings, or few letters apart.
nearest() {
    printf '%s\n' "$2" | awk -v word="$1" '
        function smallest(a, b, c) { if (b < a) a = b; return c < a ? c : a }
        function apart(s, t,    i, j, m, n, row, old, new) {
            m = length(s); n = length(t)
            for (j = 0; j <= n; j++) row[j] = j
            for (i = 1; i <= m; i++) {
                old = row[0]; row[0] = i
                for (j = 1; j <= n; j++) {
                    new = smallest(row[j] + 1, row[j - 1] + 1, old + (substr(s, i, 1) != substr(t, j, 1)))
                    old = row[j]; row[j] = new
                }
            }
            return row[n]
        }
        BEGIN { word = tolower(word) }
        $0 != "" {
            name = tolower($0)
            d = apart(word, name)
            if (word != "" && index(name, word) == 1) d = 0.5            # the beginning of a name
            else if (index(word, name) == 1 && d > 1.5) d = 1.5          # a name and something more
            if (d <= (length(word) > 3 ? 2 : 1)) print d "\t" $0
        }' | sort -n | awk -F '\t' 'NR == 1 { best = $1 } $1 <= best + 0.5 { print $2 }' | head -n 3
}
# " (did you mean a, b?)", or nothing.
did_you_mean() {
    local names
    names=$(nearest "$1" "$2" | tr '\n' ',' | sed 's/,$//; s/,/, /g')
    if [ -n "$names" ]; then printf '; did you mean %s?' "$names"; fi
}
