#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
#
# Writes what the programs of an exercise are made of.
#
#   subjects.sh student <the exercise's folder> <out>     subject.hpp: exercise.hpp as others may include it
#   subjects.sh others <the exercise's folder> <out>      subjects.cpp: library, solution, skeletons and wrong answers, all
#                                                         in one; the skeletons and wrong answers are written beside it
#
# Each subject stands in a namespace of its own, with the tests in it once more. The headers that it includes come before,
# so that they are parsed once; inside, their guards leave nothing of them. What macros an answer defines are as they were
# after it. subjects.cpp does not compile those that ANSATZ_BROKEN_<n> names, and with ANSATZ_ONLY=<n> but one.
#
# Files are included by their place in the project, or beside this one, never by a whole path: ccache hands the list of
# included files to another checkout as it is, and that one would watch the files of this one.
set -u
tools=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd) || exit 1
kind=${1:?student or others} exercise=${2:?the folder of the exercise} out=${3:?where to write}
mkdir -p "$out" || exit 1
project=$(cd "$tools/../.." && pwd) || exit 1
place=${exercise#"$project"/}

# macros_kept <header> push|pop: the macros that it changes.
macros_kept() { awk -f "$tools/macros.awk" "$1" | sed "s/.*/#pragma $2_macro(\"&\")/"; }

# The headers of the libraries that these files include, each once.
headers_of() { cat "$@" | sed -n 's/^ *# *include *\(<[^>]*>\).*/#include \1/p' | awk '!seen[$0]++'; }

write_student() {
    # Only where no brace is open a template can be specialised: else the compiler would blame whatever comes next.
    echo "template <class> struct NothingIsOpen;"
    macros_kept "$exercise/exercise.hpp" push
    echo "#include \"$place/exercise.hpp\""
    macros_kept "$exercise/exercise.hpp" pop
    echo "template <> struct NothingIsOpen<int> {};"
}

# one <n> <text...>: lines that are there for the subject n.
one() {
    local n=$1
    shift
    printf '#if !defined(ANSATZ_BROKEN_%s) && (!defined(ANSATZ_ONLY) || ANSATZ_ONLY + 0 == %s)\n' "$n" "$n"
    printf '%s\n' "$@"
    echo "#endif"
}

# place_of <file>: what to include it by, from a file in $out.
place_of() { case $1 in "$out"/*) echo "${1#"$out"/}" ;; *) echo "$place/${1#"$exercise"/}" ;; esac; }

write_others() {
    local solved tasks n name file names=(solution skeleton) files=("$exercise/solution.hpp" "$out/skeleton.hpp") wrong
    tasks=$(sed -n 's/^ *\/\/ task \([0-9]*\): .*/\1/p' "$exercise/solution.hpp" | sort -n -u | tail -n 1)
    for ((solved = 0; solved == 0 || solved < ${tasks:-0}; solved++)); do
        file=$out/skeleton.$solved.hpp
        [ "$solved" -eq 0 ] && file=$out/skeleton.hpp
        awk -v solved="$solved" -f "$tools/skeleton.awk" "$exercise/solution.hpp" > "$file" || return 1
        [ "$solved" -gt 0 ] && names+=("skeleton.$solved") files+=("$file")
    done
    names+=(library) files+=("$exercise/library.hpp")
    wrong=$(awk -v out="$out" -f "$tools/wrong.awk" "$exercise/solution.hpp" "$exercise/wrong.diff") || return 1
    for name in $wrong; do names+=("wrong.$name") files+=("$out/wrong.$name.hpp"); done

    echo "// Made by tools/exercises/subjects.sh."
    echo '#include "tools/exercises/expect.hpp"'
    echo "template <int> struct NothingIsOpen;"
    for ((n = 0; n < ${#names[@]}; n++)); do
        echo
        echo "// subject $n: ${names[n]}"
        # What the others include is no help to this one, as long as it comes first: so the solution does, and the skeletons.
        one "$n" "$(headers_of "${files[n]}")" "$(macros_kept "${files[n]}" push)" "namespace subject_$n {" \
            "static constexpr const char* tested_subject = \"${names[n]}\";" "#include \"$(place_of "${files[n]}")\"" "}" \
            "$(macros_kept "${files[n]}" pop)" "template <> struct NothingIsOpen<$n> {};"
    done
    echo
    headers_of "$exercise/test.cpp"
    for ((n = 0; n < ${#names[@]}; n++)); do
        one "$n" "namespace subject_$n {" "#include \"$place/test.cpp\"" \
            "static const ansatz::workbook::RegisteredProbe registered_probe(tested_subject, &probe);" "}"
    done
}

case $kind in
    student) target=$out/subject.hpp ;;
    others) target=$out/subjects.cpp ;;
    *) echo "usage: subjects.sh student|others <exercise> <out>" >&2; exit 2 ;;
esac
"write_$kind" > "$target.part" || { rm -f "$target.part"; exit 1; }
if [ "$kind" = student ] && cmp -s "$target.part" "$target"; then rm -f "$target.part"; else mv -f "$target.part" "$target"; fi
