# shellcheck shell=bash
# SPDX-License-Identifier: BSL-1.0
#
# Whether an exercise keeps its promises; judge.sh sources this file for `judge.sh verify`. The promises are:
#
#   - the library and the solution pass every test;
#   - every task of the skeleton fails with "not done yet: task n", for that reason and no other;
#   - where the first n tasks are done and no more, their tests pass, and those of task n + 1 say that it is not done;
#   - each wrong answer fails exactly the tests that it lists (Fails: ...), by a check and not by a crash;
#   - no test catches nothing, and there are three wrong answers at least;
#   - each wrong answer, taken for a student's, is named as the mistake it is; solution and library are named nothing;
#   - what an answer computes for the probes is the same each time, and no two tests have one name;
#   - its texts are there: the task, the hints, the scene, and the sections that it sends people to.

# shellcheck disable=SC2153  # TEXT, LISTED and the like are what judge.sh has found
PROJECT=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd) || exit 1
COURSE_CHAPTERS=7      # those of the notes; of a chapter that is not written here yet, nobody knows the sections

fault() { FAULTS=$((FAULTS + 1)); printf '  %s\n' "$*" >> "$JUDGE_SCRATCH/faults"; }

# CELL of the table: how a test came out, in one sign.
cell() {
    case $OUTCOME in
        passed) CELL=pass ;;
        failed) CELL=fail ;;
        todo) CELL=todo${TEXT##*task } ;;
        *) CELL=$OUTCOME ;;
    esac
}

# section_is_there <number>
section_is_there() {
    local chapter=${1%%.*}
    case $1 in *[!0-9.]* | '' | .* | *.) return 1 ;; esac
    if compgen -G "$PROJECT/chapters/$chapter-*" > /dev/null; then
        compgen -G "$PROJECT/chapters/$chapter-*/$1-*.cpp" > /dev/null
    else
        [ "$chapter" -ge 1 ] && [ "$chapter" -le $COURSE_CHAPTERS ]
    fi
}

# expect_todo <subject> <test> <task>: the test that has just run must have failed because this task is not done.
expect_todo() {
    if [ "$OUTCOME" != todo ]; then fault "the $1's [$2] should fail with 'not done yet: task $3', but it is '$OUTCOME': $TEXT"
    elif [ "$TEXT" != "not done yet: task $3" ]; then fault "the $1's [$2] belongs to task $3, but it says '$TEXT'"; fi
}

# expect_partly <test> <task> <done>: the same where the first tasks are done.
expect_partly() {
    local which="with tasks 1 to $3 done"
    [ "$3" -eq 1 ] && which="with only task 1 done"
    if [ "$2" -le "$3" ]; then
        [ "$OUTCOME" = passed ] || fault "$which, [$1] belongs to task $2 and should pass, but: $TEXT"
    elif [ "$2" -eq $(($3 + 1)) ]; then
        [ "$OUTCOME:$TEXT" = "todo:not done yet: task $2" ] || fault "$which, [$1] should say 'not done yet: task $2', but it is '$OUTCOME': $TEXT"
    else
        [ "$OUTCOME" = todo ] || fault "$which, [$1] belongs to task $2 and should say that it is not done, but it is '$OUTCOME': $TEXT"
    fi
}

# expect_wrong <subject> <test> <listed, between commas>
expect_wrong() {
    case $3 in
        *",$2,"*)
            case $OUTCOME in
                failed) CAUGHT="$CAUGHT,$2," ;;
                passed) fault "$1 passes [$2], which it says it fails" ;;
                *) fault "$1 should fail [$2] by a check, but it is '$OUTCOME': $TEXT" ;;
            esac ;;
        *) [ "$OUTCOME" = passed ] || fault "$1 fails [$2], which it does not list: $TEXT" ;;
    esac
}

# run_subject <subject> <kind>: a row of the table; ALL_PASSED is whether every test has passed.
run_subject() {
    local subject=$1 kind=$2 task name field row='' listed=''
    ALL_PASSED=true
    [ "$kind" = wrong ] && listed=",$(line_of "$EXERCISE" "${subject#wrong.}" Fails | tr -d ' '),"
    while IFS=$'\t' read -r task name _; do
        run_test "$PROGRAMS" "$subject" "$name"
        cell
        printf -v field '%-*s' $((${#name} > 6 ? ${#name} : 6)) "$CELL"
        row="$row $field"
        [ "$OUTCOME" = passed ] || ALL_PASSED=false
        case $kind in
            right) [ "$OUTCOME" = passed ] || fault "$subject does not pass [$name]: $TEXT" ;;
            skeleton) expect_todo skeleton "$name" "$task" ;;
            partly) expect_partly "$name" "$task" "${subject#skeleton.}" ;;
            wrong) expect_wrong "$subject" "$name" "$listed" ;;
        esac
    done <<< "$TESTS"
    printf '  %-36s%s\n' "$subject" "$row"
}

# A mistake is named by its numbers, so that numbers which change each time would name nothing, or anything.
verify_probes() {
    local subject=$1 again=$JUDGE_SCRATCH/again
    probes_of "$PROGRAMS" "$subject" "$TASKS"
    rm -f "$again"
    limited "$PROGRAMS/others" probe "$subject" "$TASKS" "$again"
    if [ -f "$PROBES" ] && ! cmp -s "$PROBES" "$again"; then fault "what $subject computes for the probes is not the same each time"; fi
}

verify_right() {
    run_subject "$1" right
    verify_probes "$1"
    mistake_of "$EXERCISE" "$PROGRAMS" "$1" "$TASKS"
    [ -z "$MISTAKES" ] || fault "$1 is right, but it is named '$(echo "$MISTAKES" | tr '\n' ' ')'"
}

verify_wrong() {
    local subject=$1 wrong=${1#wrong.} name named word
    run_subject "$subject" wrong
    $ALL_PASSED && fault "$subject passes every test: no test catches this mistake"
    for name in $(line_of "$EXERCISE" "$wrong" Fails | tr ',' ' '); do
        printf '%s\n' "$TESTS" | cut -f 2 | grep -qxF -e "$name" || fault "$subject lists a test that is not there: $name"
    done
    if [ "$OUTCOME" != missing ]; then
        verify_probes "$subject"
        mistake_of "$EXERCISE" "$PROGRAMS" "$subject" "$TASKS"
        named=$(printf '%s' "${MISTAKES:-nothing}" | tr '\n' ' ')
        [ "$named" = "${subject#wrong.}" ] || fault "$subject, taken for a student's, should be named '${subject#wrong.}', but it is named '$named'"
    fi
    for word in Mistake Why Read Fails; do
        [ -n "$(line_of "$EXERCISE" "$wrong" $word)" ] || fault "wrong.diff has no line $word: for $wrong"
    done
    for word in $(line_of "$EXERCISE" "$wrong" Read | tr ',' ' '); do
        section_is_there "$word" || fault "$wrong in wrong.diff sends people to section $word, which is not there"
    done
}

# Each level of each task's hints, with a text below its heading.
verify_hints() {
    local sentence
    while IFS= read -r sentence; do fault "$sentence"; done < <(
        "${ANSATZ_PYTHON:-python3}" "$PROJECT/tools/workshop/hints.py" "$EXERCISE/hints.md" "$TASKS")
}

verify_texts() {
    local file number
    for file in README.md exercise.hpp library.hpp solution.hpp wrong.diff test.cpp hints.md play.cpp; do
        [ -f "$EXERCISE/$file" ] || fault "there is no $file"
    done
    number=$(sed -n '1s/^# *\([0-9.]*\) .*/\1/p' "$EXERCISE/README.md" 2> /dev/null)
    if [ -z "$number" ]; then fault "README.md does not begin with '# <section> <title>'"
    elif ! section_is_there "$number"; then fault "README.md names section $number, which is not there"; fi
    [ "$(tail -n +2 "$EXERCISE/README.md" 2> /dev/null | grep -c '[^ ]')" -gt 0 ] || fault "README.md does not say what the task is"
    grep -qs 'int main(' "$EXERCISE/play.cpp" || fault "play.cpp has no scene: there is no main in it"
    verify_hints
}

# The list of the tests itself: each has a task and a name of its own, and no task is without one.
verify_list() {
    local task name
    while IFS=$'\t' read -r task name _; do
        case $task in '' | *[!0-9]* | 0*) fault "the test [$name] has no tag [task-<n>]" ;; esac
    done <<< "$(printf '%s\n' "$TESTS" | sed 's/^\t/-\t/')"
    if printf '%s\n' "$TESTS" | cut -f 2 | grep -q '^$'; then fault "a test has no name: a second tag, after its task"; fi
    for name in $(printf '%s\n' "$TESTS" | cut -f 2 | sort | uniq -d); do fault "two tests are named [$name]"; done
    for task in $(seq 1 "$TASKS"); do
        printf '%s\n' "$TESTS" | cut -f 1 | grep -qxF "$task" || fault "no test belongs to task $task"
    done
}

verify_subjects() {
    local wrong wrongs=0 name solved
    verify_right library
    verify_right solution
    run_subject skeleton skeleton
    for ((solved = 1; solved < TASKS; solved++)); do run_subject "skeleton.$solved" partly; done
    for wrong in $(wrong_answers "$EXERCISE"); do
        wrongs=$((wrongs + 1))
        verify_wrong "wrong.$wrong"
    done
    [ "$wrongs" -ge 8 ] || fault "there are $wrongs wrong answers; an exercise has eight at least"
    while IFS=$'\t' read -r _ name _; do
        case $CAUGHT in *",$name,"*) ;; *) fault "the test [$name] catches no wrong answer" ;; esac
    done <<< "$TESTS"
}

verify() {
    EXERCISE=${1%/} PROGRAMS=${2%/} FAULTS=0 CAUGHT='' TESTS='' TASKS=0
    local name
    : > "$JUDGE_SCRATCH/faults"
    if ! list_tests "$PROGRAMS" solution; then
        echo "$EXERCISE: there is no $PROGRAMS/others that lists its tests; build the target exercise.${PROGRAMS##*/}.others"
        return 1
    fi
    TESTS=$LISTED
    TASKS=$(printf '%s\n' "$TESTS" | cut -f 1 | grep -x '[0-9]*' | sort -n | tail -n 1)
    TASKS=${TASKS:-0}
    read_heads "$EXERCISE"
    verify_texts
    verify_list
    printf '%s\n' "${PROGRAMS##*/}"
    printf '  %-36s' ''
    while IFS=$'\t' read -r _ name _; do printf ' %-6s' "$name"; done <<< "$TESTS"
    echo
    verify_subjects
    if [ "$FAULTS" -gt 0 ]; then
        echo "  $FAULTS faults in ${PROGRAMS##*/}:"
        sed 's/^/  /' "$JUDGE_SCRATCH/faults"
        return 1
    fi
}
