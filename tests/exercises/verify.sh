#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
#
# Whether verifying an exercise finds what it is there to find. The programs of a real exercise are copied, one thing is
# made wrong, and tools/exercises/judge.sh must say so, in the sentence that names it.
#
#   verify.sh <the project's folder>     ANSATZ_SCRATCH lies in <the build folder>/scratch
set -u
project=${1:?the project folder}
scratch=${ANSATZ_SCRATCH:?a folder for this test}
built=${scratch%/*/*}/exercises/motion.explicit_euler
if [ ! -x "$built/solution" ]; then
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
# expect <code> <sentence>: what verifying the changed copy must say.
expect() {
    local code=$1 sentence=$2 output status
    output=$(bash "$project/tools/exercises/judge.sh" verify "$exercise" "$programs" 2>&1)
    status=$?
    if [ $status -eq "$code" ] && printf '%s\n' "$output" | grep -qF -e "$sentence"; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "FAILED: expected code $code and '$sentence', got code $status and:"
        printf '%s\n' "$output" | sed 's/^/    /'
    fi
    fresh
}
fresh

expect 0 "wrong.new_velocity                   fail         pass             fail   pass"

cp "$programs/skeleton" "$programs/solution"
expect 1 "solution does not pass [old-velocity]: not done yet: task 1"

cp "$programs/solution" "$programs/skeleton"
expect 1 "the skeleton's [old-velocity] should fail with 'not done yet: task 1', but it is 'passed'"

cp "$programs/wrong.new_velocity" "$programs/library"
expect 1 "library does not pass [old-velocity]"

cp "$programs/solution" "$programs/wrong.new_velocity"
expect 1 "wrong.new_velocity passes every test: no test catches this mistake"

rm "$programs/wrong.velocity_replaced" "$exercise/wrong/velocity_replaced.hpp"
expect 1 "the test [velocity-adds-up] catches no wrong answer"

# Its tests fail as they should, but what it computes for the probes is the solution's: a student would be told nothing.
# shellcheck disable=SC2016
mv "$programs/wrong.energy_kept" "$programs/energy_kept" &&
    printf '#!/bin/bash\nhere=${0%%/*}\n[ "$1" = probe ] && exec "$here/solution" "$@"\nexec "$here/energy_kept" "$@"\n' > "$programs/wrong.energy_kept" &&
    chmod +x "$programs/wrong.energy_kept" && rm -f "$programs"/*.probes
expect 1 "wrong.energy_kept, taken for a student's, should be named 'energy_kept', but it is named 'nothing'"

# The same with the probes of another mistake: a student would be told of one that was not made.
# shellcheck disable=SC2016
mv "$programs/wrong.energy_kept" "$programs/energy_kept" &&
    printf '#!/bin/bash\nhere=${0%%/*}\n[ "$1" = probe ] && exec "$here/wrong.new_velocity" "$@"\nexec "$here/energy_kept" "$@"\n' > "$programs/wrong.energy_kept" &&
    chmod +x "$programs/wrong.energy_kept" && rm -f "$programs"/*.probes
expect 1 "wrong.energy_kept, taken for a student's, should be named 'energy_kept', but it is named 'energy_kept new_velocity'"

# Two wrong answers with the same numbers cannot both be named.
cp "$programs/wrong.energy_kept" "$programs/wrong.amplitude_factor" && rm -f "$programs"/*.probes
expect 1 "but it is named 'amplitude_factor energy_kept'"

# Probes that are another number each time would name anything.
# shellcheck disable=SC2016
mv "$programs/wrong.energy_kept" "$programs/energy_kept" &&
    printf '#!/bin/bash\n[ "$1" = probe ] && { echo "1 $RANDOM$RANDOM" > "$3"; exit; }\nexec "${0%%/*}/energy_kept" "$@"\n' > "$programs/wrong.energy_kept" &&
    chmod +x "$programs/wrong.energy_kept" && rm -f "$programs"/*.probes
expect 1 "what wrong.energy_kept computes for the probes is not the same each time"

# A program that ends by itself, with any code, has passed nothing.
# shellcheck disable=SC2016
printf '#!/bin/bash\nexit 0\n' > "$programs/library"
expect 1 "library does not pass [old-velocity]: It ended the program (exit) before the test was over."

# Lists of tests that are none: empty, twice the same name, no name, no task, and one that breaks off.
list() { # <program> <lines, each with its \n>
    mv "$programs/$1" "$programs/real"
    # shellcheck disable=SC2016
    printf '#!/bin/bash\n[ "$1" = list ] && { printf "%%b" %q > "$2"; exit 0; }\nexec "${0%%/*}/real" "$@"\n' "$2" > "$programs/$1"
    chmod +x "$programs/$1"
}
two='1\told-velocity\ta\n1\tvelocity-adds-up\tb\n1\tfall\tc\n2\tenergy-factor\td\n'
list solution 'end\n'
expect 1 "that lists its tests"
list solution "$two"
expect 1 "that lists its tests"
list solution "${two}1\\tfall\\te\\nend\\n"
expect 1 "two tests are named [fall]"
list solution "${two}1\\t\\te\\nend\\n"
expect 1 "a test has no name"
list solution "${two}\\tfree\\te\\nend\\n"
expect 1 "the test [free] has no tag [task-<n>]"

# With task 1 solved its tests pass, and those of task 2 say task 2.
cp "$programs/skeleton" "$programs/skeleton.1"
expect 1 "with only task 1 done, [old-velocity] belongs to task 1 and should pass, but: not done yet: task 1"
cp "$programs/solution" "$programs/skeleton.1"
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
for section in 9.9.9 1.60; do
    sed -i "s/^\/\/ Read: .*/\/\/ Read:    $section/" "$exercise/wrong/new_velocity.hpp"
    expect 1 "wrong/new_velocity.hpp sends people to section $section, which is not there"
done

sed -i 's/^\/\/ Fails: .*/\/\/ Fails:   old-velocity/' "$exercise/wrong/new_velocity.hpp"
expect 1 "wrong.new_velocity fails [fall], which it does not list"

sed -i 's/^\/\/ Fails: .*/\/\/ Fails:   old-velocity, fall, speed/' "$exercise/wrong/new_velocity.hpp"
expect 1 "wrong.new_velocity lists a test that is not there: speed"

sed -i 's/^\/\/ Fails: .*/\/\/ Fails:   old-velocity, fall, velocity-adds-up/' "$exercise/wrong/new_velocity.hpp"
expect 1 "wrong.new_velocity passes [velocity-adds-up], which it says it fails"

# A program that crashes has not been caught by a check.
# shellcheck disable=SC2016
printf '#!/bin/bash\n[ "$1" = run ] && { ulimit -c 0; kill -SEGV $$; }\n' > "$programs/wrong.new_velocity"
expect 1 "wrong.new_velocity should fail [old-velocity] by a check, but it is 'crashed'"

# shellcheck disable=SC2016
printf '#!/bin/bash\n[ "$1" = run ] && while :; do :; done\n' > "$programs/wrong.new_velocity"
ANSATZ_CPU_SECONDS=1 expect 1 "wrong.new_velocity should fail [old-velocity] by a check, but it is 'endless'"

rm "$programs/wrong.new_velocity"
expect 1 "wrong.new_velocity should fail [old-velocity] by a check, but it is 'missing'"

sed -i '/^\/\/ Why:/d' "$exercise/wrong/new_velocity.hpp"
expect 1 "wrong/new_velocity.hpp has no line // Why:"

rm "$exercise"/wrong/{new_velocity,energy_kept,velocity_replaced}.hpp
expect 1 "there are 2 wrong answers; an exercise has three at least"

sed -i 's/^## Task 2: the key line/## Task 2: the end/' "$exercise/hints.md"
expect 1 "hints.md has no '## Task 2: the line'"

rm "$exercise/library.hpp"
expect 1 "there is no library.hpp"

rm "$programs/solution"
expect 1 "that lists its tests; build the target exercise.motion.explicit_euler.all_subjects"

echo "$passed passed, $failed failed"
[ $failed -eq 0 ]
