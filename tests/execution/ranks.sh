#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
#
# An ensemble on MPI ranks (ansatz/execution/on_ranks.hpp): the same results to the bit on 1, 2 and 4 ranks and on each of
# them, two messages a run, one sentence on all ranks when a run throws, and what was finished kept when a rank is killed.
#
# usage: ranks.sh <folder of the project>       with CXX and ANSATZ_SCRATCH in the environment, as ctest sets them
set -euo pipefail
project=$(cd "${1:-$(dirname "${BASH_SOURCE[0]}")/../..}" && pwd)
source "$project/tests/programs.bash"

command -v mpirun > /dev/null || skip "no mpirun (on Debian: apt install openmpi-bin)"
flags=$(pkg-config --cflags ompi-cxx 2> /dev/null) || skip "no MPI for C++ (on Debian: apt install libopenmpi-dev)"
libraries=$(pkg-config --libs ompi-cxx)
scratch=${ANSATZ_SCRATCH:-$(mktemp -d)}
mkdir -p "$scratch"
cd "$scratch"
rm -f ./*.results ./*.log ./*.[0-9]
compiler=${CXX:-c++}
printf '#include <boost/mpi/communicator.hpp>\nint main() {}\n' > probe.cpp
# shellcheck disable=SC2086 # the flags are words
"$compiler" -std=c++20 -c ${flags//-I/-isystem } probe.cpp -o probe.o > /dev/null 2>&1 || skip "no Boost.MPI (on Debian: apt install libboost-mpi-dev)"
# shellcheck disable=SC2086
compile "$compiler" "$project/tests/execution/programs/ranks.cpp" ranks.o -O1 -c ${flags//-I/-isystem }
# shellcheck disable=SC2086
"$compiler" ranks.o -o ranks -lboost_mpi -lboost_serialization $libraries

# More ranks than cores, as root in a container too; they may lie on one machine only.
export OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
export OMPI_MCA_btl_vader_single_copy_mechanism=none OMPI_MCA_plm_rsh_agent=false
# on <number of ranks> <stem> [<file> [throw | die | tell]]: rank 0 writes <stem>.0, rank 1 <stem>.1, ...
on() { timeout 120 mpirun -n "$1" ./ranks "$2" "${@:3}" > "$2.log" 2>&1; }
fail() { echo "$*"; cat ./*.log; exit 1; }
same() {    # same <number of ranks> <stem> <sentence>: every rank came to the results of one alone
    local rank
    for ((rank = 0; rank < $1; ++rank)); do
        diff one.0 "$2.$rank" > "$2.diff" || { head -n 4 "$2.diff"; fail "$3 (rank $rank of $1)"; }
    done
}

on 1 one || fail "one rank failed"
[ "$(wc -l < one.0)" -eq 80 ] || fail "one rank wrote no 40 results"
for ranks in 2 4; do
    on "$ranks" "of_$ranks" || fail "$ranks ranks failed"
    same "$ranks" "of_$ranks" "several ranks came to other results than one"
    # A rank asks, and is told that nothing is left; in between a result and the next run are a message each.
    grep -q "^rank 0: 0 runs, $((2 * (40 + ranks - 1))) messages" "of_$ranks.log" || fail "$ranks ranks sent another number of messages"
done

told="ensemble: run 20 of 40 failed: no such step"
if on 2 throw thrown.results throw; then fail "a run threw, and nothing was said"; fi
[ "$(grep -c "was told: $told; 20 results are kept in thrown.results: the same call goes on from there" throw.log)" -eq 2 ] ||
    fail "not both ranks were told of the run that threw"
on 4 after_throw thrown.results || fail "it did not go on after a run that threw"
same 4 after_throw "it came to other results when it went on"
[ "$(awk '/^rank [1-3]: / { runs += $3 } END { print runs }' after_throw.log)" -eq 20 ] || fail "it ran again what was kept"

told="ensemble: EnsembleOptions::progress threw what is no std::exception; 20 results are lost"
if on 3 tell - tell; then fail "what told of the progress threw, and nothing was said"; fi
[ "$(grep -c "was told: $told" tell.log)" -eq 3 ] || fail "not every rank was told of what threw on rank 0"

if on 2 die dead.results die; then fail "a rank was killed, and mpirun did not notice"; fi
grep -q "ensemble: a rank has died, or the program was told to end, after 20 of 40 runs" die.log || fail "nobody said that a rank has died"
on 3 after_death dead.results || fail "it did not go on after a rank had died"
same 3 after_death "it came to other results after a rank had died"

# The map of chapter 1 by two ranks is the map of one program.
# shellcheck disable=SC2086
compile "$compiler" "$project/chapters/1-motion/1.6.5-stable_region.cpp" map.o -O1 -c -I "$project/tools" -DANSATZ_ON_RANKS ${flags//-I/-isystem }
# shellcheck disable=SC2086
"$compiler" map.o -o map -lboost_mpi -lboost_serialization $libraries
ANSATZ_PICTURES=. timeout 120 mpirun -n 2 ./map > map.txt 2> map.log || fail "the stable region was not mapped by two ranks"
cmp map.txt "$project/docs/recordings/1.6.5.txt" || fail "two ranks map another stable region than one program"

echo "another ensemble" > other.results
if on 2 other other.results; then fail "the file of another ensemble was taken"; fi
[ "$(grep -c "other.results is no file of results; it begins 'another ensemble'" other.log)" -eq 2 ] || fail "not both ranks were told of the file"
echo "40 runs on 1, 2, 3 and 4 ranks: the same results, two messages a run"
