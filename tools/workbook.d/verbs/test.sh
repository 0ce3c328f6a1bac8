# shellcheck shell=bash
# SPDX-License-Identifier: BSL-1.0
#
# build everything and run the tests; arguments go to ctest
#
#   ./workbook test
#   ./workbook test -R units      those whose name contains "units"
#   ./workbook test -N            only list them
#   ./workbook test --touched     what depends on a file that was changed since the last commit
#   ./workbook test --touched main   the same since the branch left main, e.g. before a merge
#
# --touched asks the compiler's own record of what each program was made from. It builds those programs, headers alone and
# static tests and runs all tests of their modules, the mistakes of that module with g++, and always a few that are quick and
# find much. What measures time, the other compilers' sentences and the sanitizers are left to a whole run.
#
# Shows what fails, ctest's closing lines and what took longest; the whole log is build/logs/test.log.

# The files that were changed since a commit, new ones too; touched_files [the commit, HEAD without it]
touched_files() {
    local base=HEAD
    if [ -n "${1:-}" ]; then base=$(git merge-base "$1" HEAD 2> /dev/null) || return 1; fi
    { git diff --name-only "$base" && git ls-files --others --exclude-standard; } | sort -u
}

# Of the files on standard input, the objects that were made from one of them, and those that were never built here.
touched_objects() {
    local changed
    changed=$(cat)
    { printf '%s\n' "$changed" | sed "s|^|$ROOT/|"; echo; ninja -C "$BUILD" -t deps; echo;
        ninja -C "$BUILD" -t targets all | sed -n 's/\.o: CXX_COMPILER__.*/.o/p'; } 2> /dev/null | awk -v build="$ROOT/$BUILD" '
        # A path as it is seen from the root of the system: ninja gives what the compiler was given, mostly relative.
        function whole(path,    part, n, i, kept, out) {
            if (path !~ /^\//) path = build "/" path
            n = split(path, part, "/")
            for (i = 1; i <= n; i++) {
                if (part[i] == "" || part[i] == ".") continue
                if (part[i] == "..") { if (kept > 0) kept--; continue }
                name[++kept] = part[i]
            }
            for (i = 1; i <= kept; i++) out = out "/" name[i]
            return out
        }
        section == 0 { if ($0 == "") section = 1; else changed[$0] = 1; next }
        /: #deps [0-9]+/ { section = 1; object = $1; sub(/:$/, "", object); known[object] = 1; next }
        section == 1 && /^    / {
            file = substr($0, 5)
            if (!(object in touched) && file !~ /^\/usr\// && whole(file) in changed) { touched[object] = 1; print object }
            next
        }
        /\.o$/ { if (!($0 in known)) print $0 }'
}

# Builds and runs what the changed files concern; touched [the commit]
touched() {
    local files objects object modules=() targets=() names="^mirror$|^tools\\.must_not_compile$" module log=build/logs/test.log
    if [ ! -f "$BUILD/build.ninja" ]; then complain "--touched needs ninja, which knows what each program was made from"; return 2; fi
    files=$(touched_files "${1:-}") || { complain "there is no commit '$1'"; return 2; }
    if [ -z "$files" ]; then echo "Nothing was changed."; return 0; fi
    if grep -q -E '(^|/)CMakeLists\.txt$|\.cmake$|^CMakePresets\.json$' <<< "$files"; then
        say "How the project is built was changed: what that concerns only a whole ./workbook test finds."
    fi
    objects=$(touched_objects <<< "$files")
    while IFS= read -r object; do
        case $object in
            '' | peers/* | tests/CMakeFiles/peer* | *_perf.dir/* | *costs_*.dir/*) ;;
            tests/CMakeFiles/test_precompiled.dir/* | tests/CMakeFiles/test_main.dir/*) ;;
            tests/CMakeFiles/test_*.dir/*) module=${object#*/test_}; module=${module%%.dir/*}; modules+=("$module"); targets+=("test_$module") ;;
            chapters/CMakeFiles/section_*.dir/*) module=${object#*/section_}; module=${module%%.dir/*}; targets+=("section_$module"); names+="|^section\\.${module//./\\.}$" ;;
            exercises/CMakeFiles/exercise.*.student.dir/* | exercises/CMakeFiles/play.*) ;;
            exercises/CMakeFiles/exercise.*.dir/*)
                module=${object#*/CMakeFiles/}; module=${module%%.dir/*}; targets+=("$module")
                module=$(cut -d . -f 2,3 <<< "$module"); names+="|^exercises\\.${module//./\\.}$" ;;
            *) targets+=("$object") ;;
        esac
    done <<< "$objects"
    # The sentences that a header of this module says, and a mistake that was changed itself.
    while IFS= read -r module; do
        [ -n "$module" ] && names+="|^must_not_compile\\.(precompiled|${module}_.*)\\.g\\+\\+$"
    done < <(sed -n 's|^include/ansatz/\([a-z_]*\)/.*|\1|p' <<< "$files" | sort -u)
    while IFS= read -r module; do
        [ -n "$module" ] && names+="|^must_not_compile\\.$module\\."
    done < <(sed -n 's|^tests/must_not_compile/\(.*\)\.cpp$|\1|p' <<< "$files")
    for module in $(sed -n 's|^tests/\([a-z_]*\)/.*\.sh$|\1|p' <<< "$files") ${modules[@]+"${modules[@]}"}; do names+="|^$module\\."; done
    names=$(tr '|' '\n' <<< "$names" | awk '!seen[$0]++' | paste -s -d '|')
    mapfile -t targets < <(printf '%s\n' ${targets[@]+"${targets[@]}"} | sort -u)
    echo "$(wc -l <<< "$files" | tr -d ' ') files were changed; ${#targets[@]} targets depend on them"
    if [ -n "${targets[0]:-}" ]; then build "what was touched" "${targets[@]}" || return 1; fi
    ctest --test-dir "$BUILD" --output-on-failure --no-tests=error -j "$(jobs_here)" -R "$names" \
        -LE '^perf$|every_compiler' 2>&1 < /dev/null | tee "$log" | grep -v -E '^ +Start +[0-9]+:| Passed |^Internal ctest|^Test project '
    return "${PIPESTATUS[0]}"
}

verb_test() {
    provide || return 1
    configure || return 1
    if [ "${1:-}" = --touched ]; then touched "${2:-}"; return; fi
    local began
    began=$(date +%s)
    build "everything" || return 1
    local argument log=build/logs/test.log line status
    local run=(ctest --test-dir "$BUILD" --output-on-failure --no-tests=error -j "$(jobs_here)" "$@")
    for argument in "$@"; do
        case $argument in
            # Asked to talk: then nothing is kept back.
            -N | --show-only* | -V | -VV | --verbose | --extra-verbose | --print-labels | --help*)
                "${run[@]}"
                return
                ;;
        esac
    done
    "${run[@]}" 2>&1 < /dev/null | tee "$log" | while IFS= read -r line; do
        if [[ $line =~ ^\ *([0-9]+/[0-9]+)\ Test\ +#[0-9]+:\ (.*)\ \.\..*(Passed|Skipped)\  ]]; then
            progress "test ${BASH_REMATCH[1]} ${BASH_REMATCH[2]%% ..*}"
        elif [[ $line =~ ^(\ +Start\ +[0-9]+:|Internal\ ctest|Test\ project\ ) ]]; then :
        elif [ -n "$line" ]; then
            clear_progress
            printf '%s\n' "$line"
        fi
    done
    status=${PIPESTATUS[0]}
    clear_progress
    # Tests that were chosen say nothing about where all the time goes.
    if [ $# -eq 0 ] && keep_times "$began"; then
        echo
        echo "Where the time went (all of it: ./workbook doctor --times), in seconds over all jobs:"
        times_table 5
    fi
    return "$status"
}
