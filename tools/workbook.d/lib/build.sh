# shellcheck shell=bash
# SPDX-License-Identifier: BSL-1.0
#
# Configure and build, quietly: one line of progress, the whole log in build/logs, and when something
# fails its first error instead of its last.

PRESET=release

# The preset's folder, read from CMakePresets.json, where ${sourceDir} is this folder.
build_folder() {
    local folder
    folder=$(sed -n 's/.*"binaryDir"[^"]*"\([^"]*\)".*/\1/p' CMakePresets.json 2>/dev/null | head -n 1)
    # shellcheck disable=SC2016  # the names are CMake's, not the shell's
    folder=$(printf '%s' "$folder" | sed -e 's|^\${sourceDir}/||' -e "s|\${presetName}|$PRESET|")
    case $folder in '' | *'$'*) folder=build ;; esac
    echo "$folder"
}
BUILD=$(build_folder)

# As many jobs as there are cores, and memory: Boost.Units and Eigen take up to 1.5 GB a compiler.
jobs_here() {
    local cores memory
    if [ -n "${CMAKE_BUILD_PARALLEL_LEVEL:-}" ]; then echo "$CMAKE_BUILD_PARALLEL_LEVEL"; return; fi
    cores=$(nproc 2>/dev/null || getconf _NPROCESSORS_ONLN 2>/dev/null || echo 1)
    memory=$(awk '/^MemAvailable:/ { print int($2 / 1500000) }' /proc/meminfo 2>/dev/null)
    if [ -n "$memory" ] && [ "$memory" -lt "$cores" ]; then cores=$memory; fi
    [ "$cores" -lt 1 ] && cores=1
    echo "$cores"
}

# Two workbooks at once would build the same files. take_turns waits until no other one builds or judges here, and says
# so; end_turn lets the next go on. What is started in between must not inherit descriptor 8, or it would hold the turn.
take_turns() {
    command -v flock > /dev/null || return 0
    mkdir -p build && exec 8> build/workbook.lock || return 0
    if ! flock -n 8; then
        clear_progress
        echo "another ./workbook is at work in this folder; waiting for it"
        flock 8
    fi
}
end_turn() { { exec 8>&-; } 2> /dev/null; }

configure() {
    local log=build/logs/configure.log start
    mkdir -p build/logs
    # ninja where it is: it knows better what is to be done, and says how far it is. An existing build keeps its own.
    if [ ! -f "$BUILD/CMakeCache.txt" ] && [ -z "${CMAKE_GENERATOR:-}" ] && command -v ninja > /dev/null; then
        export CMAKE_GENERATOR=Ninja
    fi
    start=$(now)
    progress "configuring"
    # A folder that was moved or copied carries a cache that knows its old place.
    local fresh=() home
    home=$(sed -n "s/^CMAKE_HOME_DIRECTORY:INTERNAL=//p" "$BUILD/CMakeCache.txt" 2>/dev/null)
    if [ -n "$home" ] && [ "$home" != "$ROOT" ]; then
        echo "The project was in $home before; it is configured anew."
        fresh=(--fresh)
    fi
    take_turns
    cmake ${fresh[@]+"${fresh[@]}"} --preset "$PRESET" > "$log" 2>&1 < /dev/null 8>&-
    local status=$?
    end_turn
    if [ $status -eq 0 ]; then
        clear_progress
        [ -z "$(last_duration configure)" ] && remember configure $(($(now) - start))
        return 0
    fi
    complain "CMake could not configure the project:"
    awk '/^CMake Error/ { on = 1 } on { print; if (++lines == 12) exit }' "$log" >&2
    grep -q '^CMake Error' "$log" || tail -n 12 "$log" >&2
    say "The whole log: $log. ./workbook doctor says what is missing; a folder $BUILD configured by other means may have to be moved away."
    return 1
}

# A name for what the compiler works on, from a line of ninja's or make's.
subject() {
    local line=$1 name=''
    if [[ $line =~ CMakeFiles/([^/]+)\.dir/ ]]; then name=${BASH_REMATCH[1]}
    elif [[ $line =~ (Linking|target)\ .*[/\ ]([^/\ ]+)$ ]]; then name=${BASH_REMATCH[2]}; fi
    echo "${name/_/ }"
}

# Reads a build's output and shows how far it is; the seconds go on where a long compilation says nothing. Where there is no
# terminal that a line could overwrite itself in, it is a line of its own every half minute (PROGRESS_SECONDS). Where ANNOUNCE is
# set it is said once, if there is something to be built, and build/logs/announced is there then. A build tool tells of a
# step when it is over, so that some seconds of silence say it as well.
build_progress() {
    local text=$1 start=$2 line status said=$SECONDS
    rm -f build/logs/announced
    if [ -n "${ANNOUNCE:-}" ]; then
        while :; do
            IFS= read -r -t 3 line
            status=$?
            if [ $status -eq 0 ] && ! [[ $line =~ ^\[\ *[0-9]+(/[0-9]+|%)\]\ *(Building|Linking|the\ answers) ]]; then continue; fi
            [ $status -eq 0 ] || [ $status -gt 128 ] || break
            : > build/logs/announced
            clear_progress
            echo
            WIDTH=$((WIDTH - 2)) say "$ANNOUNCE" | sed "s/^/  $DIM/; s/\$/$PLAIN/"
            break
        done
    fi
    while :; do
        IFS= read -r -t 1 line
        status=$?
        if [ $status -eq 0 ]; then
            if [[ $line =~ ^\[\ *([0-9]+)/([0-9]+)\] ]]; then text="building ${BASH_REMATCH[1]}/${BASH_REMATCH[2]} $(subject "$line")"
            elif [[ $line =~ ^\[\ *([0-9]+)%\] ]]; then text="building ${BASH_REMATCH[1]} % $(subject "$line")"; fi
        elif [ $status -le 128 ]; then break; fi
        if $LIVE; then progress "$text  $((($(now) - start) / 1000)) s"
        elif [ $((SECONDS - said)) -ge "${PROGRESS_SECONDS:-30}" ]; then
            said=$SECONDS
            echo "  ${text% }, $(duration $(($(now) - start)))"
        fi
    done
}

# build <what, for people> [targets...]
build() {
    local what=$1 start log=build/logs/build.log target targets=()
    shift
    mkdir -p build/logs
    # KEEP_GOING=true builds what can be built, in the words of the tool at work.
    local go_on=()
    if [ "${KEEP_GOING:-}" = true ]; then
        if [ -f "$BUILD/build.ninja" ]; then go_on=(-- -k 0); else go_on=(-- -k); fi
    fi
    for target in "$@"; do targets+=(--target "$target"); done
    take_turns
    start=$(now)
    $LIVE || echo "building $what (log: $log)"
    progress "building $what"
    cmake --build "$BUILD" -j "$(jobs_here)" ${targets[@]+"${targets[@]}"} ${go_on[@]+"${go_on[@]}"} 2>&1 < /dev/null 8>&- | tee "$log" | build_progress "building $what" "$start"
    local status=${PIPESTATUS[0]} took=$(($(now) - start))
    end_turn
    clear_progress
    if [ "$status" -ne 0 ]; then
        first_error "$log"
        return 1
    fi
    # A build that had nothing to do says nothing about how long one takes.
    if grep -q -E '^\[ *[0-9]+(/[0-9]+|%)\] (Building|Linking)' "$log"; then
        echo "built $what in $(duration $took)"
        remember "build $what" "$took"
    fi
}

# The first error of a log. A sentence of the library (static_assert) says more than where it was raised.
first_error() {
    local log=$1 width
    # shellcheck disable=SC2153  # WIDTH comes from terminal.sh
    width=$((WIDTH > 60 ? WIDTH : 60))
    complain "the build failed; the first error:"
    if grep -q -m 1 -E 'error: static assertion failed' "$log"; then
        grep -m 1 -E 'error: static assertion failed' "$log" | sed "s|$ROOT/||g" | fold -s -w "$width" >&2
    elif grep -q -m 1 -E '(fatal )?error:|undefined reference|Error [0-9]' "$log"; then
        awk '/error:|undefined reference|Error [0-9]/ { on = 1 } on { print; if (++lines == 8) exit }' "$log" | sed "s|$ROOT/||g" | fold -w "$width" >&2
    else
        tail -n 8 "$log" | cut -c "1-$width" >&2
    fi
    if grep -q -E 'Killed|out of memory|cannot allocate memory' "$log"; then
        say "The compiler ran out of memory: try again with one job, CMAKE_BUILD_PARALLEL_LEVEL=1 ./workbook ..."
    fi
    say "The whole log: $log. Mend it and give the same command again: what is built already is kept."
}

# Where a target's program is.
program_of() {
    local name=$1 place
    for place in "$BUILD/$name" "$BUILD/bin/$name" "$BUILD"/chapters/*/"$name" "$BUILD/chapters/$name"; do
        if [ -f "$place" ] && [ -x "$place" ]; then echo "$place"; return 0; fi
    done
    return 1
}

# Where the time went since then, by kind, is kept in build/logs/times.tsv, a block of lines a day and minute, so that growth
# is seen. keep_times <seconds since 1970>
TIMES=build/logs/times.tsv
keep_times() {
    local day logs=() log
    for log in "$BUILD/.ninja_log" "$BUILD/Testing/Temporary/LastTest.log"; do [ -f "$log" ] && logs+=("$log"); done
    [ ${#logs[@]} -gt 0 ] || return 0
    day=$(date '+%Y-%m-%d %H:%M')
    mkdir -p build/logs
    python3 tools/workshop/times.py --since "$1" "${logs[@]}" |
        sed "s/^/$day	/" >> "$TIMES"
}
# The last block, with what each kind took in the block before that; times_table [how many kinds]
times_table() {
    [ -s "$TIMES" ] || return 1
    awk -F '\t' -v most="${1:-1000}" '
        $1 != day { day = $1; delete before; for (kind in now) before[kind] = now[kind]; delete now; n = 0 }
        { now[$2] = $4; line[++n] = $0 }
        END {
            printf "  %-34s %6s %9s %9s   %s\n", day, "number", "seconds", "before", "the dearest"
            for (i = 1; i <= n && i <= most; i++) {
                split(line[i], of, "\t")
                printf "  %-34s %6d %9.1f %9s   %.1f s %s\n", of[2], of[3], of[4], of[2] in before ? sprintf("%.1f", before[of[2]]) : "-", of[6], of[5]
            }
        }' "$TIMES"
}
