#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
# Looks at every compiler that is here.
#
# The same worlds come to the same state, to the last bit, in every build (hard case I20): g++ and clang++, each with -O0,
# -O2, -O3 and -O3 -march=native, all with -ffp-contract=off as the library's exported target asks. What is compared is
# World::hash after 300 steps, of one world for every integrator, with every force and effect of the library in some of
# them. Nothing on that path may call what two C libraries or compilers compute differently: there is sqrt, which IEEE 754
# defines, and for damping the library's own exponential (motion/decay.hpp), but no sin, cos, exp, pow or hypot.
#
# And, in the whole matrix, the same build twice gives the same bits: compiled again, run again, for each compiler. There it is
# built as for the debugger, too, and under the sanitizers, with clang++-19, and with the standard library of clang, libc++; what of
# these is not on this machine is said.
#
# In every change its corners are built, since each program takes a minute of the compiler's time: the first compiler without the
# optimiser, and each with all that it may do for this machine, beside the numbers that are pinned. .ci/run matrix builds all of it.
#
# usage: build_matrix.sh <folder of the project> [whole]     with CXX and ANSATZ_SCRATCH in the environment, as ctest sets them
set -euo pipefail
export LC_ALL=C
project=$(cd "${1:-$(dirname "${BASH_SOURCE[0]}")/../..}" && pwd)
source "$project/tests/programs.bash"
scratch=${ANSATZ_SCRATCH:-$(mktemp -d)}
mkdir -p "$scratch"
cd "$scratch"

options=("-O0" "-O2" "-O3" "-O3 -march=native")
whole=${2:-}
options_of() {    # the number of a compiler
    if [ "$whole" = whole ]; then printf '%s\n' "${options[@]}"
    elif [ "$1" -eq 0 ]; then printf '%s\n' "${options[0]}" "${options[-1]}"
    else printf '%s\n' "${options[-1]}"
    fi
}
file_of() { printf '%s%s' "${1##*/}" "${2// /}"; }
build() {    # compiler, options, what to add to the file's name
    local options
    read -ra options <<< "$2"
    [ -z "$3" ] || local launcher=()    # compiled again is compiled, not taken from the cache
    compile "$1" "$project/tests/performance/programs/worlds.cpp" "$(file_of "$1" "$2")$3" "${options[@]}"
    "./$(file_of "$1" "$2")$3" > "$(file_of "$1" "$2")$3.txt"
}
mapfile -t compilers < <(found_compilers)
for n in "${!compilers[@]}"; do
    while IFS= read -r option; do start build "${compilers[n]}" "$option" ""; done < <(options_of "$n")
    [ "$whole" != whole ] || start build "${compilers[n]}" "-O3" "-again"
done
# What else the whole matrix has: a compiler and its options a line.
others=()
if [ "$whole" = whole ]; then
    sanitizers="-O1 -g1 -fsanitize=address,undefined -fno-sanitize-recover=all"
    for compiler in "${compilers[@]}"; do others+=("$compiler|-Og -g1 -D_GLIBCXX_ASSERTIONS" "$compiler|$sanitizers"); done
    if command -v clang++ > /dev/null && printf '#include <vector>\n' | clang++ -stdlib=libc++ -E -x c++ - > /dev/null 2>&1; then
        others+=("$(command -v clang++)|-O2 -stdlib=libc++")
    else echo "not here: libc++ (on Debian: apt install libc++-14-dev libc++abi-14-dev)"; fi
    if command -v clang++-19 > /dev/null; then others+=("$(command -v clang++-19)|-O0" "$(command -v clang++-19)|-O3 -march=native")
    else echo "not here: clang++-19 (on Debian: apt install clang-19)"; fi
    for other in "${others[@]}"; do start build "${other%%|*}" "${other#*|}" ""; done
fi
all_done

reference=$(file_of "${compilers[0]}" "${options[0]}")
cat "$reference.txt"
worlds=$(grep -vc '^#' "$project/tests/performance/pinned_hashes.txt")
[ "$(sort -u "$reference.txt" | wc -l)" -eq "$worlds" ] || { echo "$worlds worlds are pinned, and that many lines should be different"; exit 1; }
[ "$(awk '{ print $NF }' "$reference.txt" | sort -u | wc -l)" -eq "$worlds" ] || { echo "$worlds worlds should have $worlds hashes"; exit 1; }
echo
faults=0
same() {    # what is compared, and two files
    local different
    different=$(diff "$2" "$3" | grep -c '^>' || true)
    if [ "$different" -eq 0 ]; then
        printf '%-72s the same bits\n' "$1"
    else
        printf '%-72s DIFFERENT in %d worlds:\n' "$1" "$different"
        diff "$2" "$3" | grep '^>' || true
        faults=$((faults + 1))
    fi
}
for n in "${!compilers[@]}"; do
    compiler=${compilers[n]}
    while IFS= read -r option; do same "${compiler##*/} $option" "$reference.txt" "$(file_of "$compiler" "$option").txt"; done \
        < <(options_of "$n")
    [ "$whole" = whole ] || continue
    "./$(file_of "$compiler" -O3)" > rerun.txt
    same "${compiler##*/} -O3, run again" "$(file_of "$compiler" -O3).txt" rerun.txt
    same "${compiler##*/} -O3, compiled again" "$(file_of "$compiler" -O3).txt" "$(file_of "$compiler" -O3)-again.txt"
done
for other in ${others[@]+"${others[@]}"}; do
    compiler=${other%%|*} option=${other#*|}
    same "${compiler##*/} $option" "$reference.txt" "$(file_of "$compiler" "$option").txt"
done
# Whoever changes what they come to does so on purpose, and puts the new number there.
grep -v '^#' "$project/tests/performance/pinned_hashes.txt" > pinned.txt
same "as they are pinned" pinned.txt "$reference.txt"
[ $faults -eq 0 ]
