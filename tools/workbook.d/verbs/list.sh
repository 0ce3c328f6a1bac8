# shellcheck shell=bash
# SPDX-License-Identifier: BSL-1.0
#
# the chapters and sections: built, run, with a picture
#
#   ./workbook list [number]      all, or what lies below a number: list 1.6

verb_list() {
    local index
    index=$(section_index)
    if [ $# -gt 0 ]; then
        local chosen
        chosen=$(at_or_below "$index" "$1")
        if [ -z "$chosen" ]; then no_section "$1" "$index"; return 2; fi
        index=$chosen
    fi
    if [ -z "$index" ]; then echo "There is no section in chapters/ yet."; return 0; fi
    local number title claim file chapter last='' state shown picture
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
        printf '  %s %s  %s  %s\n' "$(fit "$number" 6)" "$shown" "$picture" "$(fit "$what" $((WIDTH - 30)) | sed 's/ *$//')"
    done <<< "$index"
    if [ $# -eq 0 ]; then
        local module modules=''
        for module in chapters/*/what_it_costs.cpp; do
            [ -f "$module" ] || continue
            module=${module#chapters/*-}
            modules="$modules ${module%/*}"
        done
        [ -n "$modules" ] && printf '\nCosts:%s   (./workbook costs [module])\n' "$modules"
    fi
    return 0
}

# no_section <word> <index>: a sentence with what may have been meant: by number, or by title.
no_section() {
    local word=$1 index=$2 titles
    titles=$(printf '%s\n' "$index" | awk -F '\037' -v word="$(printf '%s' "$word" | tr '[:upper:]' '[:lower:]')" \
        'index(tolower($2), word) { printf "%s%s (%s)", sep, $1, $2; sep = ", " }')
    if [ -n "$titles" ]; then
        complain "sections go by number; by that name there is $titles"
    else
        complain "there is no section '$word'$(did_you_mean "$word" "$(numbers "$index")")"
    fi
    say "./workbook list shows all sections."
}
