#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
#
# What a settled pile of a thousand spheres holds of the heap, counted below operator new: most of it are the lists of
# contacts and pairs, which grow while the bodies fall and keep their room. Each bound is a little above what it is; a
# list that takes twice the room that it needs, or a further one of whole contacts, is beyond it.
#
# usage: heap.sh <folder of the project>    with CXX and ANSATZ_SCRATCH in the environment, as ctest sets them
set -euo pipefail
project=$(cd "${1:-$(dirname "${BASH_SOURCE[0]}")/../..}" && pwd)
source "$project/tests/programs.bash"
run_program tests/collision/programs/heap.cpp
