# shellcheck shell=bash
# SPDX-License-Identifier: BSL-1.0
#
# measure what accuracy costs in time on this machine
#
#   ./workbook costs              every module
#   ./workbook costs motion       one module
#   ./workbook costs motion --quick
#
# Options go to the program: --quick (3 repeats), --repeats N, --untimed (errors, work and orders only),
# --only TEXT, --check (fail when a fitted order is off the known one), --list, --help. The table goes to
# build/costs/<module>.json. Close other programs first: times are only as quiet as the machine.

cost_modules() {
    local file
    for file in chapters/*/what_it_costs.cpp; do
        [ -f "$file" ] || continue
        file=${file#chapters/*-}
        echo "${file%/*}"
    done
}

verb_costs() {
    local modules module chosen
    modules=$(cost_modules)
    chosen=$modules
    case ${1:-} in
        '' | -*) ;;
        *)
            chosen=$1
            shift
            # 1, 1-motion and motion all name the module of chapter 1.
            local folder
            for folder in chapters/*/what_it_costs.cpp; do
                folder=${folder#chapters/}
                folder=${folder%/*}
                case $chosen in "$folder" | "${folder%%-*}") chosen=${folder#*-} ;; esac
            done
            if ! printf '%s\n' "$modules" | grep -q -x -F -e "$chosen"; then
                complain "no module '$chosen' has a cost table$(did_you_mean "$chosen" "$modules")"
                [ -n "$modules" ] && say "There are: $(echo "$modules" | tr '\n' ' ')"
                return 2
            fi
            ;;
    esac
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
        "$program" --out build/costs "$@" < /dev/null || failed=$((failed + 1))
    done <<< "$chosen"
    [ "$failed" -eq 0 ]
}
