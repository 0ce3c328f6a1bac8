#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
#
# A search that is warm allocates nothing: not on grids, way points or Boost's own graphs, with a heap or with buckets, in
# one go or in slices; nor does a planner, nor a route that searches again.
#
# usage: allocation.sh <folder of the project>       with CXX and ANSATZ_SCRATCH in the environment, as ctest sets them
set -euo pipefail
project=$(cd "${1:-$(dirname "${BASH_SOURCE[0]}")/../..}" && pwd)
source "$project/tests/programs.bash"
run_program tests/paths/programs/allocation.cpp
