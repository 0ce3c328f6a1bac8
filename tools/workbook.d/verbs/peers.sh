# shellcheck shell=bash
# SPDX-License-Identifier: BSL-1.0
#
# measure the library beside others that do the same
#
#   ./workbook peers              every area
#   ./workbook peers collision    one area
#   ./workbook peers collision 30 with so many repeats
#   ./workbook peers cases        the hard cases in other engines: errors and not times, so that repeats mean nothing
#
# The table goes to build/peers/<area>.json, and at the end it is said who was fastest in each scene of what is there. A library
# that is not installed is named and left out. Compare the ratios of one run, and close other programs first.

peer_areas() {
    local file
    for file in tests/peers/*/main.cpp; do
        [ -f "$file" ] || continue
        file=${file%/main.cpp}
        echo "${file##*/}"
    done
}

verb_peers() {
    local areas area chosen repeats=${2:-}
    areas=$(peer_areas)
    chosen=${1:-$areas}
    if [ $# -gt 2 ]; then complain "peers takes an area and a number of repeats; what is '$3'? ./workbook help peers"; return 2; fi
    case $repeats in *[!0-9]*) complain "the number of repeats is a whole number, not '$repeats'"; return 2 ;; esac
    if [ $# -gt 0 ] && ! printf '%s\n' "$areas" | grep -q -x -F -e "$1"; then
        complain "there is no area '$1'$(did_you_mean "$1" "$areas")"
        say "There are: $(echo "$areas" | tr '\n' ' ')"
        return 2
    fi
    provide || return 1
    configure || return 1
    local targets=() program failed=0
    while IFS= read -r area; do targets+=("peers_$area"); done <<< "$chosen"
    build "the contest" "${targets[@]}" || return 1
    mkdir -p build/peers
    while IFS= read -r area; do
        if ! program=$(program_of "peers_$area"); then
            complain "peers_$area was built, but its program is not in $BUILD"
            return 1
        fi
        "$program" build/peers ${repeats:+"$repeats"} < /dev/null || failed=$((failed + 1))
    done <<< "$chosen"
    case $chosen in cases | scale | threads) ;; *) python3 tools/workshop/peer_times.py summary build/peers ;; esac
    [ "$failed" -eq 0 ]
}
