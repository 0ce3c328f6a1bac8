#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
#
# A warm step of a world in which bodies collide allocates nothing: with every broadphase, every response, with and without
# friction, layers, sensors and rest, while contacts begin and end and bodies fall asleep and wake.
#
# Warm means: as many contacts have been there before. Bodies bounce between walls for two seconds, and again from the
# beginning, because some lists change places with each other from step to step; then the same seconds once more, in the world
# that has the room by now. With WARM_UPS=0 it must fail. Where a heap falls apart there is more than before all the time: then no
# more than one step in forty allocates.
#
# usage: allocation.sh <folder of the project>       with CXX and ANSATZ_SCRATCH in the environment, as ctest sets them
set -euo pipefail
project=$(cd "${1:-$(dirname "${BASH_SOURCE[0]}")/../..}" && pwd)
source "$project/tests/programs.bash"
run_program tests/collision/programs/allocation.cpp -DWARM_UPS="${WARM_UPS:-2}"
