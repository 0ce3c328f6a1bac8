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
# All areas together take about half an hour on two idle cores, of which collision takes 19 minutes and soft_bodies 5. Before it
# begins it says how long what you asked for will take: as long as the last time here, if there was one.
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

# Milliseconds: the last time here, or what was measured on two idle cores; fails for an area of which nothing is known.
time_of_area() {
    last_duration "peers $1" && return
    case $1 in
        collision) echo 1140000 ;;
        soft_bodies) echo 300000 ;;
        paths) echo 210000 ;;
        threads) echo 120000 ;;
        scale) echo 100000 ;;
        *) return 1 ;;
    esac
}
# How long these areas (one a line) take together, for a person. Another number of repeats takes another time.
say_how_long() {
    local area took sum=0 told='' unknown=''
    while IFS= read -r area; do
        if took=$(time_of_area "$area"); then
            sum=$((sum + took))
            told="$told${told:+, }$area $(about "$took")"
        else unknown="$unknown${unknown:+, }$area"; fi
    done <<< "$1"
    if [[ $told == *,* ]]; then told="It takes about $(about "$sum"): $told"
    elif [ -n "$told" ]; then told="It takes about ${told#* }"; fi
    say "${told:-It is not known yet how long it takes}${unknown:+${told:+, and $unknown, of which it is not known yet}}${2:+, with the usual number of repeats}."
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
    local targets=() program failed=0 start
    while IFS= read -r area; do targets+=("peers_$area"); done <<< "$chosen"
    build "the contest" "${targets[@]}" || return 1
    say_how_long "$chosen" "$repeats"
    mkdir -p build/peers
    while IFS= read -r area; do
        if ! program=$(program_of "peers_$area"); then
            complain "peers_$area was built, but its program is not in $BUILD"
            return 1
        fi
        start=$(now)
        if ! "$program" build/peers ${repeats:+"$repeats"} < /dev/null; then failed=$((failed + 1))
        elif [ -z "$repeats" ]; then remember "peers $area" $(($(now) - start)); fi
    done <<< "$chosen"
    case $chosen in cases | scale | threads) ;; *) python3 tools/workshop/peer_times.py summary build/peers ;; esac
    [ "$failed" -eq 0 ]
}
