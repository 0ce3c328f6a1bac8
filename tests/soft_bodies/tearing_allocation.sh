#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
#
# A warm step in which a sheet tears and its vertices split allocates nothing by ImplicitEulerBy<MatrixFree>, in a world
# or in its copy: rows of the bodies to come have room. Eigen takes its memory from malloc, past operator new, so that
# one program of its own is built in which both are counted.
#
# usage: tearing_allocation.sh <folder of the project>   with CXX and ANSATZ_SCRATCH in the environment, as ctest sets
set -euo pipefail
project=$(cd "${1:-$(dirname "${BASH_SOURCE[0]}")/../..}" && pwd)
source "$project/tests/programs.bash"
run_program tests/soft_bodies/programs/tearing_allocation.cpp
