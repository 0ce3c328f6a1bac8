# shellcheck shell=bash
# SPDX-License-Identifier: BSL-1.0
#
# measure what accuracy costs in time on this machine
#
#   ./workbook costs              every module
#   ./workbook costs motion       one module
#   ./workbook costs motion --quick
#
#   --quick          3 repeats of each row
#   --repeats N      so many
#   --untimed        errors, work and orders only
#   --only TEXT      the rows whose name contains it
#   --check          fail when a fitted order is off the known one
#   --list           only name the rows
#
# The table goes to build/costs/<module>.json. Close other programs first: times are only as quiet as the machine.

cost_modules() {
    local file
    for file in chapters/*/what_it_costs.cpp; do
        [ -f "$file" ] || continue
        file=${file#chapters/*-}
        echo "${file%/*}"
    done
}

# Sorts the arguments: `chosen` is the module, `options` what goes to the program, in any order.
sort_costs_arguments() {
    chosen='' options=()
    while [ $# -gt 0 ]; do
        case $1 in
            --repeats | --only)
                if [ $# -lt 2 ]; then complain "$1 needs a value"; return 2; fi
                options+=("$1" "$2")
                shift ;;
            --quick | --untimed | --check | --list) options+=("$1") ;;
            *)
                if [ -n "$chosen" ]; then complain "one module at a time; what is '$1'? ./workbook help costs"; return 2; fi
                chosen=$1 ;;
        esac
        shift
    done
}

# One of the modules, by its name or by its chapter's: 1, 1-motion and motion all name the module of chapter 1.
choose_module() { # <modules>
    local folder modules=$1
    for folder in chapters/*/what_it_costs.cpp; do
        folder=${folder#chapters/}
        folder=${folder%/*}
        case $chosen in "$folder" | "${folder%%-*}") chosen=${folder#*-} ;; esac
    done
    printf '%s\n' "$modules" | grep -q -x -F -e "$chosen" && return
    complain "no module '$chosen' has a cost table$(did_you_mean "$chosen" "$modules")"
    [ -n "$modules" ] && say "There are: $(echo "$modules" | tr '\n' ' ')"
    return 2
}

verb_costs() {
    local modules module chosen options
    modules=$(cost_modules)
    sort_costs_arguments "$@" || return 2
    if [ -n "$chosen" ]; then choose_module "$modules" || return 2; else chosen=$modules; fi
    if [ -z "$chosen" ]; then echo "No chapter has a what_it_costs.cpp yet."; return 0; fi
    provide || return 1
    configure || return 1
    local targets=()
    while IFS= read -r module; do targets+=("costs_$module"); done <<< "$chosen"
    build "the cost table$([ ${#targets[@]} -gt 1 ] && echo s)" "${targets[@]}" || return 1

    local program failed=0
    while IFS= read -r module; do
        if ! program=$(program_of "costs_$module"); then
            complain "costs_$module was built, but its program is not in $BUILD"
            return 1
        fi
        "$program" --out build/costs ${options[@]+"${options[@]}"} < /dev/null || failed=$((failed + 1))
    done <<< "$chosen"
    [ "$failed" -eq 0 ]
}
