#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
#
# Compiles subjects.cpp, all subjects of an exercise but the student's. A wrong answer that does not compile is left out
# and named, and harms no other: the file `broken` beside subjects.cpp then says which and why.
#
#   compile.sh <the compiler's command>
set -u
for argument in "$@"; do case $argument in *subjects.cpp) source=$argument ;; esac; done
folder=${source%/*}
rm -f "$folder/broken"
log=$("$@" 2>&1)
status=$?
if [ $status -ne 0 ] && grep -q '^// subject [0-9]*: wrong\.' "$source"; then
    without=()
    while read -r _ _ number name; do
        number=${number%:}
        said=$("$@" -fsyntax-only "-DANSATZ_ONLY=$number" 2>&1) && continue
        case $name in wrong.*) ;; *) without=(); break ;; esac       # without the solution nothing can be judged
        without+=("-DANSATZ_BROKEN_$number")
        error=$(printf '%s\n' "$said" | grep -m 1 'error:')
        printf '%s\t%s\n' "$name" "${error##*/}" >> "$folder/broken"
        printf '%s does not compile and is left out:\n%s\n' "$name" "$error" >&2
    done < <(grep '^// subject [0-9]*: ' "$source")
    if [ ${#without[@]} -gt 0 ]; then
        log=$("$@" "${without[@]}" 2>&1)
        status=$?
    fi
fi
[ -n "$log" ] && printf '%s\n' "$log" >&2
exit $status
