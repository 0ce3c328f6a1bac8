#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
#
# A warm step of a world with springs allocates nothing: not with explicit integrators, not when springs break or bodies
# fall asleep, and not with implicit Euler and conjugate gradients, whose pattern, vectors and preconditioner are kept.
# Eigen takes its memory from malloc, past operator new, so that one program of its own is built in which both tell.
#
# usage: allocation.sh <folder of the project>       with CXX and ANSATZ_SCRATCH in the environment, as ctest sets them
set -euo pipefail
project=$(cd "${1:-$(dirname "${BASH_SOURCE[0]}")/../..}" && pwd)
source "$project/tests/programs.bash"
run_program tests/springs/programs/allocation.cpp
