#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
#
# Writes what the programs of an exercise are made of.
#
#   subjects.sh student <the exercise's folder> <out> [python3]    subject.hpp: exercise.hpp as others may include it
#   subjects.sh others <the exercise's folder> <out> [python3]     subjects.cpp: library, solution, skeletons and wrong
#                                                                  answers, all in one; the skeletons and wrong answers
#                                                                  are written beside it
#
# What stands in them is said in tools/workshop/subjects.py. Files are included by their place in the project, or beside
# this one, never by a whole path: ccache hands the list of included files to another checkout as it is, and that one
# would watch the files of this one.
set -u
tools=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd) || exit 1
kind=${1:?student or others} exercise=${2:?the folder of the exercise} out=${3:?where to write} python=${4:-python3}
mkdir -p "$out" || exit 1
project=$(cd "$tools/../.." && pwd) || exit 1
place=${exercise#"$project"/}

# run <module> <arguments...>: -I and -S, because nothing but Python's own is needed and the start is then half as long.
run() { "$python" -I -S "$project/tools/workshop/$1.py" "${@:2}"; }

write_student() { run subjects student "$exercise" "$place"; }

write_others() {
    local skeletons wrong names=()
    skeletons=$(run skeleton --all "$out" "$exercise/solution.hpp") || return 1
    wrong=$(run wrong make "$exercise/solution.hpp" "$exercise/wrong.diff" "$out") || return 1
    mapfile -t names < <(printf '%s\n' solution "$skeletons" library; printf '%s\n' "$wrong" | sed -n 's/./wrong.&/p')
    run subjects others "$exercise" "$place" "$out" "${names[@]}"
}

case $kind in
    student) target=$out/subject.hpp ;;
    others) target=$out/subjects.cpp ;;
    *) echo "usage: subjects.sh student|others <exercise> <out> [python3]" >&2; exit 2 ;;
esac
"write_$kind" > "$target.part" || { rm -f "$target.part"; exit 1; }
if [ "$kind" = student ] && cmp -s "$target.part" "$target"; then rm -f "$target.part"
else mv -f "$target.part" "$target"; fi
