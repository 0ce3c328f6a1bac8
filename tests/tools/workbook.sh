#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
#
# What ./workbook says without building anything: in a copy with made-up chapters, in a folder whose
# name has a space, called from elsewhere. Prints one line for every check that fails.
#
#   workbook.sh <the project's folder>

set -u
project=${1:?the project folder}
scratch=$(mktemp -d) || exit 1
trap 'rm -rf "$scratch"' EXIT
tree="$scratch/a folder"
mkdir -p "$tree/tools" "$tree/chapters/1-motion" "$tree/chapters/4-soft_bodies" || exit 1
cp "$project/workbook" "$tree/" && cp -R "$project/tools/workbook.d" "$tree/tools/" || exit 1

section() { printf '// SPDX-License-Identifier: BSL-1.0\n// %s\nint main() {}\n' "$2" > "$tree/chapters/$1"; }
section 1-motion/1.10-a.cpp "1.10 Tenth"
section 1-motion/1.1-b.cpp "1.1 Newton's first law: a body at rest costs nothing"
section 1-motion/1.6-c.cpp "1.6 Numerical integration: a claim"
section 1-motion/1.6.1-d.cpp "1.6.1 Explicit Euler: every step adds energy"
section 1-motion/1.6.2-e.cpp "1.6.2 Implicit Euler: a colon: in the claim"
section 4-soft_bodies/4.1-cloth_of_springs.cpp "A comment that names nothing"
printf '// SPDX-License-Identifier: BSL-1.0\nint main() {}\n' > "$tree/chapters/1-motion/what_it_costs.cpp"

failures=0
passed=0
unset COLUMNS NO_COLOR CI
# expect <exit code> <text that must be there> <arguments...>
expect() {
    local code=$1 text=$2 output status
    shift 2
    output=$(cd / && "$tree/workbook" "$@" 2>&1 < /dev/null)
    status=$?
    if [ $status -eq "$code" ] && printf '%s\n' "$output" | grep -q -F -e "$text" &&
        ! printf '%s\n' "$output" | grep -q -F -e "command not found"; then
        passed=$((passed + 1))
    else
        failures=$((failures + 1))
        echo "FAILED: workbook $*: expected code $code and '$text', got code $status and:"
        printf '%s\n' "$output" | sed 's/^/    /'
    fi
}

expect 0 "take the tour" help
expect 0 "./workbook section 1.6.2" help section
expect 0 "The one command of Ansatz" --help
expect 2 "did you mean list?" lsit
expect 2 "there is no verb 'xyzzy'" xyzzy
expect 2 "there is no verb '1.1'; did you mean section 1.1?" 1.1
expect 2 "there is no verb '../lib/build'" ../lib/build
expect 2 "did you mean costs?" help cost
expect 0 "4 Soft bodies" list
expect 0 "4.1    not built           Cloth of springs" list
expect 0 "1.1    not built" list
expect 0 "Costs: motion" list
# Where no line can overwrite itself, a long build says how far it is now and then, in lines of their own.
said=$(cd "$tree" && ROOT=$tree bash -c '. tools/workbook.d/lib/terminal.sh; . tools/workbook.d/lib/build.sh
    printf "[ 35%%] Building CXX object chapters/CMakeFiles/section_1.7.dir/x.o\n" |
        PROGRESS_SECONDS=0 build_progress "building it" "$(now)"' 2>&1)
if [[ $said =~ ^"  building 35 % section 1.7, "[0-9.]+" s"$ ]]; then passed=$((passed + 1))
else
    failures=$((failures + 1))
    echo "FAILED: a build without a terminal says: $said"
fi
# What has been built is found: a program of its own, or that of all sections of its chapter, and it is run.
mkdir -p "$tree/build/chapters" "$scratch/stub" || exit 1
program() { printf '#!/bin/sh\n%s\n' "$2" > "$tree/build/chapters/$1" && chmod +x "$tree/build/chapters/$1"; }
program section_1.1 'echo "this is section $1"'
expect 0 "1.1    built               Newton" list
program sections_motion 'case $1 in --has) test "$2" = 1.10 ;; *) echo "section $1 of them all" ;; esac'
expect 0 "1.10   built               Tenth" list
expect 0 "1.6.1  not built" list
printf '#!/bin/sh\n' > "$scratch/stub/cmake" && chmod +x "$scratch/stub/cmake" # all is up to date
PATH=$scratch/stub:$PATH expect 0 "this is section 1.1" section 1.1
PATH=$scratch/stub:$PATH expect 0 "section 1.10 of them all" section 1.10
PATH=$scratch/stub:$PATH expect 1 "the program section_1.6.1 was not built" section 1.6.1
rm -rf "$tree/build"
expect 0 "1.6.2" list 1.6
expect 2 "did you mean 1.6.1" section 1.6.3
expect 2 "by that name there is 1.6.1 (Explicit Euler), 1.6.2 (Implicit Euler)" section euler
# A number whose chapter is not there is near no section.
expect 2 "workbook: there is no chapter 9" section 9
expect 2 "The chapters: 1 Motion, 4 Soft bodies." section 9.1
expect 2 "did you mean 1.1, 1.10" list 1.1.9
expect 0 "./workbook section <number> runs one." section
expect 2 "did you mean motion?" costs moton
expect 2 "./workbook section 1.6 shows one section" tour 1.6
expect 0 "build the documentation site" help docs
expect 2 "docs takes no 'now'" docs now

# The hard cases: from a list alone, without a test, a build or a run.
mkdir -p "$tree/tools/workshop" "$tree/tests" || exit 1
cp "$project"/tools/workshop/{cases,hard_cases,case_verdicts,__init__}.py "$tree/tools/workshop/" || exit 1
printf '== C Contact\nC1 Two bodies part.\nC28 Convex shapes.\n    does not apply yet: there are none\n' > "$tree/tests/hard_cases.txt"
expect 0 "./workbook cases --last" help cases
expect 0 "2 rows: 1 not run, 1 does not apply yet" cases --last
expect 0 "there are none" cases --last c28
expect 1 "./workbook test builds the tests" cases
# A word is named as it was typed, by the workbook as always.
expect 2 "workbook: there is no row and no group 'q9'" cases q9
expect 2 "The groups: C Contact." cases --last foo
expect 0 "there are none" cases --last C28
expect 2 "cases knows no option '--lst'" cases --lst

# Too many arguments are not silently left out, and nothing is built to find that out.
expect 2 "what is '2'?" list 1.6 2
expect 2 "what is '1.7'?" section 1.6 1.7
expect 2 "doctor takes no 'x'" doctor x
expect 2 "costs knows no option '--quik'" costs motion --quik
expect 2 "did you mean motion?" costs --quick moton
expect 2 "what is 'water'?" costs --quick motion water
expect 0 "measure what accuracy costs" costs --help
expect 0 "./workbook exercise semi_implicit_euler" exercise --help
COLUMNS=99999999999999999999 expect 0 "Cloth of springs" list

# Nothing is wider than the terminal, and nothing is cut.
section 1-motion/1.12-wide.cpp "1.12 A title: and a claim that goes on for much longer than there is room beside it"
printf 'C29 A row that asks for much more than there is room for beside it, so that it goes on below.\n' >> "$tree/tests/hard_cases.txt"
for width in 80 60; do
    for words in "list" "cases --last" "help" $(sed 's/^/--help:/' < <(cd "$tree/tools/workbook.d/verbs" && printf '%s\n' *.sh)); do
        case $words in --help:*) words=${words#--help:} words="${words%.sh} --help" ;; esac
        # shellcheck disable=SC2086
        wide=$(cd / && COLUMNS=$width "$tree/workbook" $words 2>&1 < /dev/null | LC_ALL=C.UTF-8 awk -v most=$width 'length > most || /…/')
        if [ -z "$wide" ]; then passed=$((passed + 1))
        else failures=$((failures + 1)); printf 'FAILED: in %s columns, workbook %s says\n%s\n' "$width" "$words" "$wide"; fi
    done
done
expect 0 "                             than there is room beside it" list 1.12
expect 0 "                          beside it, so that it goes on below." cases --last
COLUMNS=60 expect 0 "                                with what is built" cases --help
rm "$tree/chapters/1-motion/1.12-wide.cpp"

# Whoever asks a verb for help gets its help, with an example, and nothing else happens; what a verb does not know it refuses with
# a sentence, and nothing is begun. Of both, a folder build would be left behind, or cmake would find no project here.
before=$(find "$tree" | sort)
for file in "$tree"/tools/workbook.d/verbs/*.sh; do
    name=${file##*/}
    name=${name%.sh}
    expect 0 "./workbook $name" "$name" --help
    expect 2 "$name knows no option '--frobnicate'" "$name" --frobnicate
done
expect 0 "build everything and run the tests" test --help
expect 0 "build everything and run the tests" test -R units --help
expect 0 "measure what accuracy costs" costs motion --quick -h
expect 2 "./workbook docs --help says what it takes" docs -Z
expect 2 "-LE, --rerun-failed" test --frobnicate
expect 2 "did you mean --rerun-failed?" test --rerun-faild
expect 2 "test knows no option '--version'" test --version
expect 2 "Its options: --times, --checks." doctor --time
expect 2 "./workbook test -R units" test units
expect 2 "./workbook test -R units" test -L world units
expect 2 "--touched stands alone" test --touched -R units
expect 2 "--touched stands alone" test -V --touched
# What is chosen for --touched is one regular expression, whatever is among it twice.
names=$(. "$tree/tools/workbook.d/verbs/test.sh"; printf '%s\n' 'object o.o' 'mistake a' 'mistake b' 'section 1.6' 'script mirror' | touched_names)
for name in mirror must_not_compile.precompiled.g++ must_not_compile.a.g++ must_not_compile.b.g++ section.1.6; do
    if grep -qE "$names" <<< "$name"; then passed=$((passed + 1)); else echo "not chosen by $names: $name"; failures=$((failures + 1)); fi
done
if grep -qE "$names" <<< "section.1x6"; then echo "chosen by $names: section.1x6"; failures=$((failures + 1)); fi
expect 2 "there is no commit 'nowhere'" test --touched nowhere
expect 2 "test takes no 'b'" test --touched a b
expect 2 "doctor takes one option at a time" doctor --times --checks
expect 2 "what is 'x'?" peers collision 3 x
expect 0 "soft_bodies 5" peers --help
expect 2 "what is 'list'?" help costs list
if [ "$(find "$tree" | sort)" = "$before" ]; then passed=$((passed + 1))
else failures=$((failures + 1)); echo "FAILED: help or a refusal left something behind"; fi
# What ctest knows is handed on, with its value: cmake is asked first, and finds no project.
for words in "-R units -N" "-j8" "-LE perf --show-only=json-v1" "--repeat until-fail:2" "--no-tests=ignore" "-VV"; do
    # shellcheck disable=SC2086
    expect 1 "CMake could not configure the project" test --yes $words
done
rm -rf "$tree/build"

# How long it takes to measure is said before: what was written down, or how long it took here, with the usual repeats.
mkdir -p "$tree/tests/peers/scale" "$tree/tests/peers/cases" "$tree/build" || exit 1
: > "$tree/tests/peers/scale/main.cpp"
: > "$tree/tests/peers/cases/main.cpp"
# shellcheck disable=SC2016  # the word of the stand-in
printf '#!/bin/sh\necho "measured with ${2:-its own} repeats"\n' > "$tree/build/peers_scale" && chmod +x "$tree/build/peers_scale"
cp "$tree/build/peers_scale" "$tree/build/peers_cases" || exit 1
PATH=$scratch/stub:$PATH expect 0 "It takes about 2 min, with the usual number of repeats." peers scale 3
if [ -f "$tree/build/logs/durations.tsv" ] && grep -q peers "$tree/build/logs/durations.tsv"; then
    failures=$((failures + 1)); echo "FAILED: what other repeats took is taken for the usual time"
fi
PATH=$scratch/stub:$PATH expect 0 "measured with its own repeats" peers scale
PATH=$scratch/stub:$PATH expect 0 "It takes about 0 s." peers scale
printf 'peers scale\t%s\t2020-01-01\n' 1170000 >> "$tree/build/logs/durations.tsv"
PATH=$scratch/stub:$PATH expect 0 "It takes about 20 min, and cases, of which it is not known yet." peers
rm -rf "$tree/build" "$tree/tests/peers"

# The version of what tells it as a number.
for version in '#define PUGIXML_VERSION 190:1.9' '#\tdefine PUGIXML_VERSION 1130 // 1.13:1.13'; do
    printf '%b\n' "${version%:*}" > "$scratch/pugixml.hpp"
    said=$(. "$tree/tools/workbook.d/verbs/doctor.sh"; version_of pugixml "$scratch/pugixml.hpp")
    if [ "$said" = "${version##*:}" ]; then passed=$((passed + 1)); else failures=$((failures + 1)); echo "FAILED: $version is told as $said"; fi
done

# Exercises by name, by a part of it, by a section above them, by the path of a file.
mkdir -p "$tree/exercises/1-motion"
for name in explicit_euler implicit_euler drag; do
    mkdir "$tree/exercises/1-motion/$name" && : > "$tree/exercises/1-motion/$name/test.cpp"
done
echo '# 1.6.1 Explicit Euler' > "$tree/exercises/1-motion/explicit_euler/README.md"
echo '# 1.6.2 Implicit Euler' > "$tree/exercises/1-motion/implicit_euler/README.md"
for name in exercise hint; do
    expect 2 "1.6.1 explicit_euler" $name euler
    expect 2 "1.6.2 implicit_euler" $name 1.6
done
expect 1 "exercises/1-motion/drag/hints.md is not there" hint exercises/1-motion/drag/exercise.hpp
expect 1 "exercises/1-motion/drag/hints.md is not there" hint "$tree/exercises/1-motion/drag/wrong.diff"
expect 1 "exercises/1-motion/implicit_euler/hints.md is not there" hint implicit
expect 0 "0      missing    drag                  motion.drag" list
# Who wrote what does not compile is told where it stands, as after every other failure.
mkdir -p "$tree/build/exercises" "$tree/tools/exercises" "$scratch/broken" && cp "$project/tools/exercises/judge.sh" "$tree/tools/exercises/" || exit 1
cp "$project/tools/workshop/first_error.py" "$tree/tools/workshop/" || exit 1
echo 'int answer = ' > "$tree/exercises/1-motion/drag/exercise.hpp"
printf 'CMAKE_HOME_DIRECTORY:INTERNAL=%s\n' "$tree" > "$tree/build/CMakeCache.txt"
: > "$tree/build/build.ninja"
printf '#!/bin/sh\necho "exercises/1-motion/drag/exercise.hpp:1:14: error: expected an expression"\nexit 1\n' > "$scratch/broken/cmake"
chmod +x "$scratch/broken/cmake"
for text in "the first error is at exercises/1-motion/drag/exercise.hpp:1" "  task   exercises/1-motion/drag/README.md" \
    "  yours  exercises/1-motion/drag/exercise.hpp" "  next   ./workbook exercise drag, or ./workbook watch"; do
    PATH=$scratch/broken:$PATH expect 1 "$text" exercise drag
done
rm -r "$tree/exercises" "$tree/build"

# 1.1 is not 1.10, though they are the same number.
lines=$(cd / && "$tree/workbook" list 1.1 | grep -c '^  1\.')
if [ "$lines" -eq 1 ]; then passed=$((passed + 1)); else failures=$((failures + 1)); echo "FAILED: list 1.1 shows $lines sections"; fi
# Sections stand in the order of their numbers: 1.6.2 before 1.10.
order=$(cd / && "$tree/workbook" list | awk '/^  [0-9]/ { printf "%s ", $1 }')
if [ "$order" = "1.1 1.6 1.6.1 1.6.2 1.10 4.1 " ]; then passed=$((passed + 1)); else failures=$((failures + 1)); echo "FAILED: the order is $order"; fi
# Nothing but plain text where nobody watches.
if (cd / && "$tree/workbook" list) | grep -q $'\033'; then failures=$((failures + 1)); echo "FAILED: colours in a pipe"; else passed=$((passed + 1)); fi
# A verb is one file.
# shellcheck disable=SC2016
printf '# SPDX-License-Identifier: BSL-1.0\n#\n# say hello\nverb_hello() { echo "hello $1"; }\n' > "$tree/tools/workbook.d/verbs/hello.sh"
expect 0 "hello world" hello world
expect 0 "say hello" help

# What only the docs need, only the docs ask for. Nothing is installed here: apt-get and sudo are stand-ins that fail.
mkdir "$scratch/bin"
for name in apt-get sudo; do
    printf '#!/bin/sh\necho "E: asked for $*"\nexit 100\n' > "$scratch/bin/$name"
    chmod +x "$scratch/bin/$name"
done
printf '# SPDX-License-Identifier: BSL-1.0\n#\n# what is missing\nverb_lacks() { echo "lacks: $(missing_packages "$1")."; }\n' > "$tree/tools/workbook.d/verbs/lacks.sh"
export ANSATZ_MATHJAX=$scratch/nowhere
kept=$PATH
PATH=$scratch/bin:$PATH
expect 0 "libjs-mathjax." lacks docs
expect 1 "libjs-mathjax" docs
if (cd / && "$tree/workbook" lacks course) | grep -q 'mathjax'; then failures=$((failures + 1)); echo "FAILED: the course asks for MathJax"; else passed=$((passed + 1)); fi
PATH=$kept
unset ANSATZ_MATHJAX

echo "$passed passed, $failures failed"
[ $failures -eq 0 ]
