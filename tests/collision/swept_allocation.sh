#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
#
# A warm world with Swept allocates nothing in a step full of impacts, and a query nothing when the caller's vector has
# room; and a step that is taken back and done again allocates nothing the second time.
#
# usage: swept_allocation.sh <folder of the project>    with CXX and ANSATZ_SCRATCH in the environment, as ctest sets them
set -euo pipefail
project=$(cd "${1:-$(dirname "${BASH_SOURCE[0]}")/../..}" && pwd)
source "$project/tests/programs.bash"
run_program tests/collision/programs/swept_allocation.cpp
