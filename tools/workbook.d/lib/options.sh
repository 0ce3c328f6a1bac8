# shellcheck shell=bash
# SPDX-License-Identifier: BSL-1.0
#
# What a verb may be told. Its help is what decides: an option is known where the help names it, with the value that it takes in
# capital letters ("--repeats N"), so that there is no option without its word of help, and none that is only promised.

# The options that a verb's help names, one a line; " VALUE" behind one that takes a value.
options_in_help() {
    help_of "$1" | grep -oE '(^|[ ,(])--?[A-Za-z]+[a-z-]*( [A-Z]+)?' |
        sed -E 's/^[ ,(]//; s/ [A-Z]+$/ VALUE/' | grep -v -x -e --help | awk '!seen[$0]++'
}

# check_options <verb> <arguments...>: refuses an option that the verb does not know, before anything is begun. WORDS are the
# arguments that are neither an option nor its value. A verb that hands options on says which in options_of_<verb>.
check_options() {
    local verb=$1 known argument option takes_value=false
    shift
    WORDS=()
    known=$(options_in_help "$verb"; if declare -F "options_of_$verb" > /dev/null; then "options_of_$verb"; fi)
    for argument in "$@"; do
        case $argument in
            -?*)
                option=$argument
                case $argument in --*=*) option=${argument%%=*}= ;; esac
                if [[ $argument =~ ^-j[0-9]+$ ]]; then option=-j; fi
                takes_value=false
                case $'\n'$known$'\n' in
                    *$'\n'"$option VALUE"$'\n'*) if [ "$option" = "$argument" ]; then takes_value=true; fi ;;
                    *$'\n'"$option"$'\n'* | *$'\nANY\n'*) ;;
                    *) unknown_option "$verb" "$argument" "$known"; return 2 ;;
                esac
                ;;
            *)
                if ! $takes_value; then WORDS+=("$argument"); fi
                takes_value=false
                ;;
        esac
    done
}

# A sentence with what may have been meant, and what there is.
unknown_option() { # <verb> <option> <those that are known>
    local told
    told=$(options_in_help "$1" | sed 's/ VALUE$//' | awk '!seen[$0]++' | paste -s -d , - | sed 's/,/, /g')
    complain "$1 knows no option '$2'$(did_you_mean "$2" "$(sed 's/ VALUE$//; s/=$//' <<< "$3" | awk '!seen[$0]++')")"
    say "${told:+Its options: $told. }./workbook $1 --help says what it takes."
}
