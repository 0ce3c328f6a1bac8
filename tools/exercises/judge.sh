#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
#
# Judges the answers to an exercise by running the programs that test them, each test in a process of its own.
#
#   judge.sh verify <the exercise's folder> <the folder of its programs>
#
# shows submissions x tests and ends with 0 if the exercise keeps its promises:
#   - the library and the solution pass every test;
#   - every task of the skeleton fails with "not done yet: task n", for that reason and no other;
#   - each wrong answer fails exactly the tests that it lists (// Fails: ...), by a check and not by a crash;
#   - no test catches nothing, and there are three wrong answers at least;
#   - each wrong answer, taken for a student's, is named as the mistake it is; solution and library are named nothing.
#
# The workbook sources this file for a student's answer, from which the functions below are: run_test, mistake_of.
set -u

JUDGE_SCRATCH=${JUDGE_SCRATCH:-$(mktemp -d)} || exit 1
trap 'rm -rf "$JUDGE_SCRATCH"' EXIT
CPU_SECONDS=${ANSATZ_CPU_SECONDS:-10}

# limited <arguments...>: a program with an end: seconds of CPU, four times as long on the clock.
limited() {
    { (ulimit -c 0 -t "$CPU_SECONDS"; exec timeout -k 1 $((4 * CPU_SECONDS)) "$@") > "$JUDGE_SCRATCH/printed" 2>&1 < /dev/null; } 2> /dev/null
}

# run_test <program> <test>: OUTCOME is passed, failed, todo, threw, crashed, endless or missing; TEXT says why, PRINTED
# holds what the program printed by itself.
run_test() {
    local program=$1 test=$2 file=$JUDGE_SCRATCH/verdict status
    rm -f "$file"
    if [ ! -x "$program" ]; then OUTCOME=missing TEXT="it was not built" PRINTED=''; return; fi
    limited "$program" run "$test" "$file"
    status=$?
    TEXT=$(cat "$file" 2>/dev/null)
    PRINTED=$(head -c 4000 "$JUDGE_SCRATCH/printed" | tr -d '\000')
    case $status in
        0) OUTCOME=passed ;;
        10) OUTCOME=failed ;;
        11) OUTCOME=todo ;;
        12) OUTCOME=threw TEXT="It threw an exception: $TEXT" ;;
        124 | 137 | 152) OUTCOME=endless TEXT="It did not come to an end within $CPU_SECONDS s: is there a loop that never ends, or far too many steps?" ;;
        139 | 138) OUTCOME=crashed TEXT="It crashed (segmentation fault): memory was used that is not there, or a function calls itself without end." ;;
        136) OUTCOME=crashed TEXT="It crashed (arithmetic exception): an integer was divided by zero." ;;
        134) OUTCOME=crashed TEXT="It was aborted: $(printf '%s\n' "$PRINTED" | sed -n "s/.*\\(Assertion .*\\)/\\1/p" | head -n 1) (an index out of range, memory overwritten, ...)"
            PRINTED=$(printf '%s\n' "$PRINTED" | grep -v 'Assertion') ;;
        132) OUTCOME=crashed TEXT="It crashed (illegal instruction): something undefined was done, as using a pointer that points nowhere." ;;
        *) OUTCOME=crashed TEXT="It ended with code $status." ;;
    esac
}

# tests_of <program>: every test as task<TAB>name<TAB>sentence, by task.
tests_of() {
    limited "$1" list || return 1
    sort -s -n -k 1,1 "$JUDGE_SCRATCH/printed"
}

# probes_of <program> <tasks>: the file with what it computes; made anew when the program is.
probes_of() {
    local program=$1 tasks=$2 file=$1.probes
    if [ ! -f "$file" ] || [ "$program" -nt "$file" ]; then
        limited "$program" probe "$tasks" "$file.part"
        [ -f "$file.part" ] && mv -f "$file.part" "$file"
    fi
    echo "$file"
}

# mistake_of <the exercise's folder> <the programs' folder> <whose> <tasks>: the names of the wrong answers that compute
# the same, one a line. A program whose wrong answer is gone from the exercise does not count.
mistake_of() {
    local exercise=$1 folder=$2 whose=$3 tasks=$4 wrong
    local files=()
    for wrong in "$exercise"/wrong/*.hpp; do
        wrong=${wrong##*/}
        wrong=$folder/wrong.${wrong%.hpp}
        [ -x "$wrong" ] && files+=("$(probes_of "$wrong" "$tasks")")
    done
    [ ${#files[@]} -gt 0 ] || return 0
    local mine solution
    mine=$(probes_of "$folder/$whose" "$tasks")
    solution=$(probes_of "$folder/solution" "$tasks")
    limited "$folder/solution" mistake "$mine" "$solution" "${files[@]}"
    sed -n 's|^.*/wrong\.\(.*\)\.probes$|\1|p' "$JUDGE_SCRATCH/printed"
}

# line_of <file> <word>: what a wrong answer says of itself: // Mistake: ..., Why, Read, Fails; continued lines are joined.
line_of() {
    awk -v word="// $2:" '
        index($0, word) == 1 { text = substr($0, length(word) + 1); on = 1; next }
        on && /^\/\/  +/ { sub(/^\/\/ +/, " "); text = text $0; next }
        on { exit }
        END { sub(/^ +/, "", text); print text }' "$1"
}

# ---------------------------------------------------------------------------------------------------------- verify

fault() { FAULTS=$((FAULTS + 1)); printf '  %s\n' "$*" >> "$JUDGE_SCRATCH/faults"; }

# A cell of the table: how a test came out, in one sign.
cell() {
    case $OUTCOME in
        passed) echo "pass" ;;
        failed) echo "fail" ;;
        todo) echo "todo${TEXT##*task }" ;;
        *) echo "$OUTCOME" ;;
    esac
}

verify_subject() { # <subject> <kind>
    local subject=$1 kind=$2 task name row='' caught='' listed=''
    [ "$kind" = wrong ] && listed=",$(line_of "$EXERCISE/wrong/${subject#wrong.}.hpp" Fails | tr -d ' '),"
    while IFS=$'\t' read -r task name _; do
        run_test "$PROGRAMS/$subject" "$name"
        row="$row $(printf '%-*s' $((${#name} > 6 ? ${#name} : 6)) "$(cell)")"
        case $kind in
            right) [ "$OUTCOME" = passed ] || fault "$subject does not pass [$name]: $TEXT" ;;
            skeleton)
                if [ "$OUTCOME" != todo ]; then fault "the skeleton's [$name] should fail with 'not done yet: task $task', but it is '$OUTCOME': $TEXT"
                elif [ "$TEXT" != "not done yet: task $task" ]; then fault "the skeleton's [$name] belongs to task $task, but it says '$TEXT'"; fi ;;
            wrong)
                case $listed in
                    *",$name,"*)
                        case $OUTCOME in
                            failed) CAUGHT="$CAUGHT,$name," ;;
                            passed) fault "$subject passes [$name], which it says it fails" ;;
                            *) fault "$subject should fail [$name] by a check, but it is '$OUTCOME': $TEXT" ;;
                        esac ;;
                    *) [ "$OUTCOME" = passed ] || fault "$subject fails [$name], which it does not list: $TEXT" ;;
                esac
                [ "$OUTCOME" = passed ] || caught=yes ;;
        esac
    done <<< "$TESTS"
    printf '  %-36s%s\n' "$subject" "$row"
    if [ "$kind" = wrong ]; then
        local named
        [ -n "$caught" ] || fault "$subject passes every test: no test catches this mistake"
        for name in $(echo "$listed" | tr ',' ' '); do
            printf '%s\n' "$TESTS" | cut -f 2 | grep -qxF "$name" || fault "$subject lists a test that is not there: $name"
        done
        named=$(mistake_of "$EXERCISE" "$PROGRAMS" "$subject" "$TASKS" | tr '\n' ' ')
        [ "$named" = "${subject#wrong.} " ] || fault "$subject, taken for a student's, should be named '${subject#wrong.}', but it is named '${named:-nothing}'"
        for name in Mistake Why Read Fails; do
            [ -n "$(line_of "$EXERCISE/wrong/${subject#wrong.}.hpp" $name)" ] || fault "wrong/${subject#wrong.}.hpp has no line // $name:"
        done
    elif [ "$kind" = right ]; then
        named=$(mistake_of "$EXERCISE" "$PROGRAMS" "$subject" "$TASKS" | tr '\n' ' ')
        [ -z "$named" ] || fault "$subject is right, but it is named '$named'"
    fi
}

verify() {
    EXERCISE=${1%/} PROGRAMS=${2%/} FAULTS=0 CAUGHT='' TESTS=''
    local file task name wrong wrongs=0 level
    : > "$JUDGE_SCRATCH/faults"
    if ! TESTS=$(tests_of "$PROGRAMS/solution") || [ -z "$TESTS" ]; then
        echo "$EXERCISE: there is no $PROGRAMS/solution that lists its tests; build the target exercise.${PROGRAMS##*/}.all_subjects"
        return 1
    fi
    TASKS=$(printf '%s\n' "$TESTS" | cut -f 1 | sort -n | tail -n 1)
    for file in README.md exercise.hpp library.hpp solution.hpp test.cpp hints.md play.cpp; do
        [ -f "$EXERCISE/$file" ] || fault "there is no $file"
    done
    for task in $(seq 1 "$TASKS"); do
        printf '%s\n' "$TESTS" | cut -f 1 | grep -qxF "$task" || fault "no test belongs to task $task"
        for level in question place shape line; do
            grep -q -i "^## Task $task: .*$level" "$EXERCISE/hints.md" 2>/dev/null || fault "hints.md has no '## Task $task: the $level'"
        done
    done
    printf '%s\n' "${PROGRAMS##*/}"
    printf '  %-36s' ''
    while IFS=$'\t' read -r _ name _; do printf ' %-6s' "$name"; done <<< "$TESTS"
    echo
    verify_subject library right
    verify_subject solution right
    verify_subject skeleton skeleton
    for wrong in "$EXERCISE"/wrong/*.hpp; do
        [ -f "$wrong" ] || continue
        wrongs=$((wrongs + 1))
        wrong=${wrong##*/}
        verify_subject "wrong.${wrong%.hpp}" wrong
    done
    [ "$wrongs" -ge 3 ] || fault "there are $wrongs wrong answers; an exercise has three at least"
    while IFS=$'\t' read -r _ name _; do
        case $CAUGHT in *",$name,"*) ;; *) fault "the test [$name] catches no wrong answer" ;; esac
    done <<< "$TESTS"
    if [ "$FAULTS" -gt 0 ]; then
        echo "  $FAULTS faults in ${PROGRAMS##*/}:"
        sed 's/^/  /' "$JUDGE_SCRATCH/faults"
        return 1
    fi
}

if [ "${BASH_SOURCE[0]}" = "$0" ]; then
    case ${1:-} in
        verify) verify "${2:?the folder of the exercise}" "${3:?the folder of its programs}" ;;
        *) echo "usage: judge.sh verify <exercise> <programs>" >&2; exit 2 ;;
    esac
fi
