# shellcheck shell=bash
# SPDX-License-Identifier: BSL-1.0
#
# the chapters, sections and exercises, and how far you are
#
#   ./workbook list               all of them
#   ./workbook list 1.6           what lies below a number

verb_list() {
    if [ $# -gt 1 ]; then complain "list takes one number; what is '$2'?"; return 2; fi
    local index
    index=$(section_index)
    if [ $# -gt 0 ]; then
        local chosen
        chosen=$(at_or_below "$index" "$1")
        if [ -z "$chosen" ]; then no_section "$1" "$index"; return 2; fi
        index=$chosen
    fi
    if [ -z "$index" ]; then echo "There is no section in chapters/ yet."; return 0; fi
    local number title claim file chapter last='' state shown picture digits
    digits=$(longest_number "$index")
    while IFS=$SEP read -r number title claim file; do
        chapter=$(chapter_title "$file")
        if [ "$chapter" != "$last" ]; then
            [ -n "$last" ] && echo
            heading "${number%%.*} $chapter"
            last=$chapter
        fi
        state=$(state_of "$number" "$file")
        picture='       '
        [ -n "$(pictures_of "$number")" ] && picture='picture'
        case $state in
            run) shown="$GREEN$(fit run 9)$PLAIN" ;;
            built) shown=$(fit built 9) ;;
            changed) shown="$YELLOW$(fit changed 9)$PLAIN" ;;
            *) shown="$DIM$(fit "$state" 9)$PLAIN" ;;
        esac
        local what=$title
        [ -n "$claim" ] && [ "$WIDTH" -gt 79 ] && what="$title: $claim"
        printf '  %s %s  %s  ' "$(fit "$number" "$digits")" "$shown" "$picture"
        beside $((23 + digits)) "$what"
    done <<< "$index"
    if [ $# -eq 0 ]; then
        local module modules=''
        for module in chapters/*/what_it_costs.cpp; do
            [ -f "$module" ] || continue
            module=${module#chapters/*-}
            modules="$modules ${module%/*}"
        done
        if [ -n "$modules" ]; then
            echo
            say "Costs:$modules   (./workbook costs [module])"
        fi
    fi
    list_exercises "${1:-}"
    return 0
}

# longest_number <index>: how wide the column of numbers must be, for they are what one types.
longest_number() { printf '%s\n' "$1" | awk -F '\037' '{ if (length($1) > n) n = length($1) } END { print (n > 6 ? n : 6) }'; }

# list_exercises [number]: each with what has come of it.
list_exercises() {
    local index number id title folder state shown done=0 count=0 digits
    index=$(exercise_index)
    [ $# -gt 0 ] && [ -n "$1" ] && index=$(at_or_below "$index" "$1")
    [ -n "$index" ] || return 0
    echo
    heading "Exercises"
    digits=$(longest_number "$index")
    find_untouched
    while IFS=$SEP read -r number id title folder; do
        state=$(state_of_exercise "$id" "$folder")
        count=$((count + 1))
        case $state in
            done) shown="$GREEN$(fit done 9)$PLAIN"; done=$((done + 1)) ;;
            started) shown="$YELLOW$(fit started 9)$PLAIN" ;;
            missing) shown="$RED$(fit "$state" 9)$PLAIN" ;;
            *) shown="$DIM$(fit "$state" 9)$PLAIN" ;;
        esac
        printf '  %s %s  %s  ' "$(fit "$number" "$digits")" "$shown" "$(fit "${id#*.}" 20)"
        beside $((36 + digits)) "$title"
    done <<< "$index"
    printf '\n%s of %s done   (./workbook exercise [name])\n' "$done" "$count"
}

# The chapters of an index: "1 Motion, 2 Collision"
chapters_of() {
    local number title claim file last='' separator=''
    while IFS=$SEP read -r number title claim file; do
        [ "${number%%.*}" = "$last" ] && continue
        last=${number%%.*}
        printf '%s%s %s' "$separator" "$last" "$(chapter_title "$file")"
        separator=', '
    done <<< "$1"
}

# no_section <word> <index>: a sentence with what may have been meant: by number, or by title. Where a number's chapter is
# not there, no section is near it.
no_section() {
    local word=$1 index=$2 titles
    if [[ $word =~ ^([0-9]+)(\.|$) ]] && ! numbers "$index" | grep -q -E "^${BASH_REMATCH[1]}(\.|\$)"; then
        complain "there is no chapter ${BASH_REMATCH[1]}"
        say "The chapters: $(chapters_of "$index"). ./workbook list shows their sections."
        return
    fi
    titles=$(printf '%s\n' "$index" | awk -F '\037' -v word="$(printf '%s' "$word" | tr '[:upper:]' '[:lower:]')" \
        'index(tolower($2), word) { printf "%s%s (%s)", sep, $1, $2; sep = ", " }')
    if [ -n "$titles" ]; then
        complain "sections go by number; by that name there is $titles"
    else
        complain "there is no section '$word'$(did_you_mean "$word" "$(numbers "$index")")"
    fi
    say "./workbook list shows all sections."
}
