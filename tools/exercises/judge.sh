#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
#
# Judges the answers to an exercise by running the programs that test them, each test in a process of its own.
#
#   judge.sh verify <the exercise's folder> <the folder of its programs>
#
# shows submissions x tests and ends with 0 if the exercise keeps its promises; they are listed in verify.sh beside this
# file. The workbook sources this file for a student's answer, from which the functions below are. Those that run a program
# leave what they found in variables, not on the standard output: in a subshell, Ctrl-C would not find the program.
set -u

JUDGE_SCRATCH=${JUDGE_SCRATCH:-$(mktemp -d)} || exit 1
trap 'rm -rf "$JUDGE_SCRATCH"' EXIT
CPU_SECONDS=${ANSATZ_CPU_SECONDS:-10}
PRINTED_MEGABYTES=20
MEMORY_GIGABYTES=4

# The address sanitizer takes terabytes of addresses for itself, so that a program with it has no limit of memory.
memory_limit_of() {
    if [ "$1" = "${MEMORY_KNOWN_OF:-}" ]; then return; fi
    MEMORY_KNOWN_OF=$1 MEMORY_LIMIT=$((MEMORY_GIGABYTES * 1024 * 1024))
    if LC_ALL=C grep -q -a __asan_init "$1"; then MEMORY_LIMIT=unlimited; fi
}

# limited <program> <arguments...>: a program with an end: seconds of CPU, four times as long on the clock, and so much
# output and memory. It is waited for and not simply called: a trap acts while the shell waits, and else only afterwards.
# On its standard input it gets JUDGES_WORD, new each time and written nowhere, without which it cannot say "passed".
# An exercise's own check calls this some hundred times, and each process that the shell starts beside it costs as much as
# the test that is run.
limited() {
    local status
    memory_limit_of "$1"
    JUDGES_WORD=${SRANDOM:-$RANDOM$RANDOM}${SRANDOM:-$RANDOM$RANDOM}
    (
        ulimit -c 0 -t "$CPU_SECONDS" -f $((PRINTED_MEGABYTES * 1024))
        ulimit -v "$MEMORY_LIMIT" 2> /dev/null      # not every system has this limit
        # `others` ends itself by an alarm (main.cpp); a student's program is ended by timeout, which is one process more.
        case $1 in */others) ANSATZ_SECONDS=$((4 * CPU_SECONDS)) exec "$@" ;; esac
        exec timeout -k 1 $((4 * CPU_SECONDS)) "$@"
    ) > "$JUDGE_SCRATCH/printed" 2>&1 <<< "$JUDGES_WORD" &
    RUNNING=$!
    { wait "$RUNNING"; } 2> /dev/null               # the shell's own remark on a program that crashes
    status=$?
    RUNNING=''
    return $status
}

# Ends the program that is running, and what it has started: `timeout` leads a group of its own.
end_running() {
    [ -n "${RUNNING:-}" ] || return 0
    { kill -KILL -- "-$RUNNING" || kill -KILL "$RUNNING"; } 2> /dev/null
    RUNNING=''
}

# Nothing in a file that a program is to write, as if it had not been written: no process has to be started for it.
without() { if [ -f "$1" ] && [ ! -L "$1" ]; then : > "$1"; else rm -f "$1"; fi }

# The text of an assertion that failed, on standard input, or nothing.
assertion_in() { sed -n 's/.*\(Assertion .*\)/\1/p' | head -n 1; }

# crash_of <status>: OUTCOME and TEXT of a program that a signal has ended; fails where none has.
crash_of() {
    local assertion
    OUTCOME=crashed
    case $1 in
        124 | 137 | 142 | 152) OUTCOME=endless TEXT="It did not come to an end within $CPU_SECONDS s: is there a loop that never ends, or far too many steps?" ;;
        153) OUTCOME=flooded TEXT="It printed more than $PRINTED_MEGABYTES MB: is there output in a loop that never ends?" ;;
        139 | 138) TEXT="It crashed (segmentation fault): memory was used that is not there, or a function calls itself without end." ;;
        136) TEXT="It crashed (arithmetic exception): an integer was divided by zero." ;;
        134)
            assertion=$(printf '%s\n' "$PRINTED" | assertion_in)
            if [ -n "$assertion" ]; then TEXT="It was aborted: $assertion (an index out of range, memory overwritten, ...)"
            else TEXT="It was aborted: something called std::abort(), or memory was overwritten."; fi
            PRINTED=$(printf '%s\n' "$PRINTED" | grep -v 'Assertion') ;;
        132) TEXT="It crashed (illegal instruction): something undefined was done, as using a pointer that points nowhere." ;;
        129 | 13[0135] | 14[013-9] | 15[01]) TEXT="It was ended by signal $(($1 - 128))." ;;
        *) return 1 ;;
    esac
}

# thrown <what>: the sentence for an exception that nobody caught.
thrown() {
    case $1 in
        std::bad_alloc) echo "It asked for more than $MEMORY_GIGABYTES GB of memory (std::bad_alloc): does something grow without end, or is a size wrong?" ;;
        *) echo "It threw an exception: $1" ;;
    esac
}

what_was_printed() {
    PRINTED=''
    if [ -s "$JUDGE_SCRATCH/printed" ]; then PRINTED=$(head -c 4000 "$JUDGE_SCRATCH/printed" | tr -d '\000'); fi
}

# not_there <the folder of the programs> <program> <subject>: TEXT says why a subject is not there; fails where it is.
not_there() {
    TEXT="it was not built"
    [ -x "$2" ] || return 0
    [ "$3" != student ] && [ -f "$1/broken" ] || return 1
    TEXT=$(awk -F '\t' -v subject="$3" '$1 == subject { print "it does not compile: " $2 }' "$1/broken")
    [ -n "$TEXT" ]
}

# run_test <the folder of the programs> <subject> <test>: OUTCOME is passed, failed, todo, threw, crashed, endless, flooded,
# ended or missing; TEXT says why, PRINTED holds what the program printed by itself. What counts is what the test's own main
# has written at its end, "passed" with the judge's word: an answer may end the program with any code, and write into any
# file.
run_test() {
    local program file=$JUDGE_SCRATCH/verdict status
    if [ "$2" = student ]; then program=$1/student; else program=$1/others; fi
    without "$file"
    if not_there "$1" "$program" "$2"; then OUTCOME=missing PRINTED=''; return; fi
    limited "$program" run "$2" "$3" "$file"
    status=$?
    what_was_printed
    crash_of "$status" && return
    OUTCOME='' TEXT=''
    # shellcheck disable=SC2162  # backslashes and blanks stay
    { IFS= read -r OUTCOME && IFS= read -r -d '' TEXT; } 2> /dev/null < "$file"
    TEXT=${TEXT%$'\n'}
    [ "$OUTCOME" = "passed $JUDGES_WORD" ] && OUTCOME=believed
    case $status:$OUTCOME in
        0:believed) OUTCOME=passed ;;
        0:failed | 0:todo) ;;
        0:threw) TEXT=$(thrown "$TEXT") ;;
        20:*) OUTCOME=crashed TEXT="Its result could not be written: is the disk full?" ;;
        *) OUTCOME=ended TEXT="It ended the program (exit) before the test was over." ;;
    esac
}

# list_tests <the folder of the programs> <subject>: LISTED is every test as task<TAB>name<TAB>sentence, by task. Where there
# is none, or the list has no end, it fails and TEXT says why.
list_tests() {
    local program file=$JUDGE_SCRATCH/tests status
    if [ "$2" = student ]; then program=$1/student; else program=$1/others; fi
    LISTED='' TEXT='' PRINTED=''
    without "$file"
    if [ ! -x "$program" ]; then TEXT="It was not built."; return 1; fi
    limited "$program" list "$2" "$file"
    status=$?
    what_was_printed
    if crash_of "$status"; then TEXT="$TEXT That was before main: look at what a global variable does."; return 1; fi
    if [ "$(tail -n 1 "$file" 2> /dev/null)" != "end $JUDGES_WORD" ]; then
        TEXT="It ended the program (exit) before main: look at what a global variable does."
        return 1
    fi
    LISTED=$(sed '$d' "$file" | sort -s -n -k 1,1)
    [ -n "$LISTED" ] || { TEXT="It has no test at all."; return 1; }
}

# probes_of <the folder of the programs> <subject> <tasks>: PROBES is the file with what it computes; made anew when the
# program is.
probes_of() {
    local program
    if [ "$2" = student ]; then program=$1/student; else program=$1/others; fi
    PROBES=$1/$2.probes
    [ -f "$PROBES" ] && [ ! "$program" -nt "$PROBES" ] && return
    limited "$program" probe "$2" "$3" "$PROBES.$$"
    [ -f "$PROBES.$$" ] && mv -f "$PROBES.$$" "$PROBES"
}

# The names of the wrong answers of an exercise, one a line.
wrong_answers() { sed -n 's/^=== *\([a-z0-9_]*\) *$/\1/p' "$1/wrong.diff" 2> /dev/null; }

# mistake_of <the exercise's folder> <the programs' folder> <whose> <tasks>: MISTAKES are the names of the wrong answers
# that compute the same, one a line.
mistake_of() {
    local exercise=$1 folder=$2 whose=$3 tasks=$4 wrong mine
    local files=()
    MISTAKES=''
    for wrong in $(wrong_answers "$exercise"); do
        probes_of "$folder" "wrong.$wrong" "$tasks"
        files+=("$PROBES")
    done
    [ ${#files[@]} -gt 0 ] || return 0
    probes_of "$folder" "$whose" "$tasks"
    mine=$PROBES
    probes_of "$folder" solution "$tasks"
    limited "$folder/others" mistake "$mine" "$PROBES" "${files[@]}"
    # shellcheck disable=SC2034  # the caller's
    MISTAKES=$(sed -n 's|^.*/wrong\.\(.*\)\.probes$|\1|p' "$JUDGE_SCRATCH/printed")
}

# read_heads <the exercise's folder>: HEADS is what its wrong answers say of themselves, read once for all that is asked
# of them: name<TAB>word<TAB>text, a line each, and a line's end before the first.
read_heads() {
    HEADS_OF=$1 HEADS=''
    [ -f "$1/wrong.diff" ] || return 0
    HEADS=$'\n'$("${ANSATZ_PYTHON:-python3}" "$(dirname "${BASH_SOURCE[0]}")/../workshop/wrong.py" heads "$1/wrong.diff")
}

# line_of <the exercise's folder> <wrong answer> <word>: what a wrong answer says of itself: Mistake: ..., Why, Read, Fails;
# continued lines are joined. Not found by `read`, which makes a system call for each letter.
line_of() {
    local key=$'\n'$2$'\t'$3$'\t' rest
    [ "${HEADS_OF:-}" = "$1" ] || read_heads "$1"
    rest=${HEADS#*"$key"}
    if [ "$rest" != "$HEADS" ]; then printf '%s\n' "${rest%%$'\n'*}"; fi
}

if [ "${BASH_SOURCE[0]}" = "$0" ]; then
    trap 'end_running; exit 130' INT TERM
    # shellcheck source=/dev/null
    . "$(dirname "${BASH_SOURCE[0]}")/verify.sh" || exit 1
    case ${1:-} in
        verify) verify "${2:?the folder of the exercise}" "${3:?the folder of its programs}" ;;
        *) echo "usage: judge.sh verify <exercise> <programs>" >&2; exit 2 ;;
    esac
fi
