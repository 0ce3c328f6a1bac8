#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
#
# Whether verifying an exercise finds what it is there to find. The programs of a real exercise are copied, one thing is
# made wrong, and tools/exercises/judge.sh must say so, in the sentence that names it. What a subject does is made wrong by a
# script in the place of the program of all subjects, which passes to it what it leaves as it is.
#
#   verify.sh <the project's folder>     ANSATZ_SCRATCH lies in <the build folder>/scratch
set -u
project=${1:?the project folder}
scratch=${ANSATZ_SCRATCH:?a folder for this test}
built=${scratch%/*/*}/exercises/motion.explicit_euler
if [ ! -x "$built/others" ]; then
    echo "skipped: the exercises are not built here (ANSATZ_EXERCISES is off)"
    exit 0
fi

passed=0
failed=0
fresh() {
    rm -rf "$scratch" && mkdir -p "$scratch/source" || exit 1
    cp -R "$project/exercises/1-motion/explicit_euler" "$scratch/source/" && cp -R "$built" "$scratch/" || exit 1
    exercise=$scratch/source/explicit_euler programs=$scratch/motion.explicit_euler
}
# expect <code> <sentences...>: what verifying the changed copy must say.
expect() {
    local code=$1 sentence output status
    output=$(bash "$project/tools/exercises/judge.sh" verify "$exercise" "$programs" 2>&1)
    status=$?
    for sentence in "${@:2}"; do
        if [ $status -eq "$code" ] && printf '%s\n' "$output" | grep -qF -e "$sentence"; then
            passed=$((passed + 1))
        else
            failed=$((failed + 1))
            echo "FAILED: expected code $code and '$sentence', got code $status and:"
            printf '%s\n' "$output" | sed 's/^/    /'
        fi
    done
    fresh
}
fresh

expect 0 "wrong.new_velocity                   fail         pass             fail   pass"

# instead <lines of bash>: what the program does for `$1 $2`, what and of which subject; `as <subject>` is what another does.
instead() {
    mv "$programs/others" "$programs/real" && rm -f "$programs"/*.probes
    {
        echo '#!/bin/bash'
        echo 'real=${0%/*}/real what=$1 whose=$2'
        echo 'as() { exec "$real" "$what" "$1" "${others[@]}"; }'
        echo 'others=("${@:3}")'
        printf '%s\n' "$@" 'exec "$real" "$@"'
    } > "$programs/others"
    chmod +x "$programs/others"
}
# for_subject <subject> <what it does>: that and nothing else.
for_subject() { instead "if [ \"\$whose\" = $1 ]; then $2; fi"; }

for_subject solution 'as skeleton'
expect 1 "solution does not pass [old-velocity]: not done yet: task 1"

for_subject skeleton 'as solution'
expect 1 "the skeleton's [old-velocity] should fail with 'not done yet: task 1', but it is 'passed'"

for_subject library 'as wrong.new_velocity'
expect 1 "library does not pass [old-velocity]"

for_subject wrong.new_velocity 'as solution'
expect 1 "wrong.new_velocity passes every test: no test catches this mistake"

without() { sed -i "/^=== $1\$/,/^\$/d" "$exercise/wrong.diff"; }
caught=$(awk '/^=== / { name = $2 } /^Fails:.*velocity-adds-up/ { print name }' "$exercise/wrong.diff")
for wrong in $caught; do without "$wrong"; done
expect 1 "the test [velocity-adds-up] catches no wrong answer"

# Its tests fail as they should, but what it computes for the probes is the solution's: a student would be told nothing.
for_subject wrong.energy_kept '[ "$what" = probe ] && as solution'
expect 1 "wrong.energy_kept, taken for a student's, should be named 'energy_kept', but it is named 'nothing'"

# The same with the probes of another mistake: a student would be told of one that was not made.
for_subject wrong.energy_kept '[ "$what" = probe ] && as wrong.new_velocity'
expect 1 "wrong.energy_kept, taken for a student's, should be named 'energy_kept', but it is named 'energy_kept new_velocity'"

# Two wrong answers with the same numbers cannot both be named.
for_subject wrong.amplitude_factor 'as wrong.energy_kept'
expect 1 "but it is named 'amplitude_factor energy_kept'"

# Probes that are another number each time would name anything.
for_subject wrong.energy_kept '[ "$what" = probe ] && { echo "1 $RANDOM$RANDOM" > "$4"; exit; }'
expect 1 "what wrong.energy_kept computes for the probes is not the same each time"

# A program that ends by itself, with any code, has passed nothing; nor has one that says so without the judge's word.
for_subject library 'exit 0'
expect 1 "library does not pass [old-velocity]: It ended the program (exit) before the test was over."
for_subject library '[ "$what" = run ] && { echo passed > "$4"; exit 0; }'
expect 1 "library does not pass [old-velocity]: It ended the program (exit) before the test was over."

# Lists of tests that are none: empty, twice the same name, no name, no task, and one that breaks off.
list() { # <lines, each with its \n>
    instead "if [ \"\$what\" = list ]; then read -r word; printf '%b' '$1' | sed \"s/^end\$/end \$word/\" > \"\$3\"; exit 0; fi"
}
two='1\told-velocity\ta\n1\tvelocity-adds-up\tb\n1\tfall\tc\n2\tenergy-factor\td\n'
list 'end\n'
expect 1 "that lists its tests"
list "$two"
expect 1 "that lists its tests"
list "${two}1\\tfall\\te\\nend\\n"
expect 1 "two tests are named [fall]"
list "${two}1\\t\\te\\nend\\n"
expect 1 "a test has no name"
list "${two}\\tfree\\te\\nend\\n"
expect 1 "the test [free] has no tag [task-<n>]"

# With task 1 solved its tests pass, and those of task 2 say task 2.
for_subject skeleton.1 'as skeleton'
expect 1 "with only task 1 done, [old-velocity] belongs to task 1 and should pass, but: not done yet: task 1"
for_subject skeleton.1 'as solution'
expect 1 "with only task 1 done, [energy-factor] should say 'not done yet: task 2', but it is 'passed'"

# Texts that say nothing, or that send people to where nothing is.
: > "$exercise/README.md"
expect 1 "README.md does not begin with"
sed -i '2,$d' "$exercise/README.md"
expect 1 "README.md does not say what the task is"
: > "$exercise/play.cpp"
expect 1 "play.cpp has no scene"
sed -i '/^## Task 2: the key line/q' "$exercise/hints.md"
expect 1 "hints.md has no text below '## Task 2: the line'"
# head_line <wrong answer> <word> <text>: another line of its head; without a text the line goes.
head_line() {
    sed -i -E "/^=== $1\$/,/^@@/{/^$2:/,/^(Read|Fails|@@)/{/^($2:| )/d}}" "$exercise/wrong.diff"
    [ -n "${3:-}" ] && sed -i "/^=== $1\$/a $2:    $3" "$exercise/wrong.diff"
    return 0
}
for section in 9.9.9 1.60; do
    head_line new_velocity Read "$section"
    expect 1 "new_velocity in wrong.diff sends people to section $section, which is not there"
done

head_line new_velocity Fails "old-velocity"
expect 1 "wrong.new_velocity fails [fall], which it does not list"

head_line new_velocity Fails "old-velocity, fall, speed"
expect 1 "wrong.new_velocity lists a test that is not there: speed"

head_line new_velocity Fails "old-velocity, fall, velocity-adds-up"
expect 1 "wrong.new_velocity passes [velocity-adds-up], which it says it fails"

# A program that crashes has not been caught by a check; and it harms no other.
for_subject wrong.new_velocity '[ "$what" = run ] && { ulimit -c 0; kill -SEGV $$; }'
expect 1 "wrong.new_velocity should fail [old-velocity] by a check, but it is 'crashed'" \
    "wrong.velocity_replaced              pass         fail             fail   pass"

for_subject wrong.new_velocity '[ "$what" = run ] && while :; do :; done'
ANSATZ_CPU_SECONDS=1 expect 1 "wrong.new_velocity should fail [old-velocity] by a check, but it is 'endless'"

# What was left out because it does not compile is missing, with the reason, and harms no other either.
printf "wrong.new_velocity\twrong.new_velocity.hpp:3:1: error: expected ';'\n" > "$programs/broken"
expect 1 "wrong.new_velocity should fail [old-velocity] by a check, but it is 'missing': it does not compile: wrong.new_velocity.hpp:3:1: error: expected ';'" \
    "wrong.velocity_replaced              pass         fail             fail   pass"

head_line new_velocity Why
expect 1 "wrong.diff has no line Why: for new_velocity"

for wrong in $(sed -n 's/^=== //p' "$exercise/wrong.diff" | tail -n +8); do without "$wrong"; done
expect 1 "there are 7 wrong answers; an exercise has eight at least"

sed -i 's/^## Task 2: the key line/## Task 2: the end/' "$exercise/hints.md"
expect 1 "hints.md has no '## Task 2: the line'"

rm "$exercise/library.hpp"
expect 1 "there is no library.hpp"

rm "$exercise/wrong.diff"
expect 1 "there is no wrong.diff"

rm "$programs/others"
expect 1 "that lists its tests; build the target exercise.motion.explicit_euler.others"

echo "$passed passed, $failed failed"
[ $failed -eq 0 ]
