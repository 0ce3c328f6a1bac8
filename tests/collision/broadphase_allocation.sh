#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
#
# A warm broadphase allocates nothing: one that has seen a scene of moving bodies finds the pairs of the same bodies, moved
# on, without operator new. One that was given room for all finds those of ever more bodies.
#
# usage: broadphase_allocation.sh <folder of the project>    with CXX and ANSATZ_SCRATCH in the environment, as ctest sets them
set -euo pipefail
project=$(cd "${1:-$(dirname "${BASH_SOURCE[0]}")/../..}" && pwd)
source "$project/tests/programs.bash"
run_program tests/collision/programs/broadphase_allocation.cpp
