#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
#
# Bodies that collide in numbers of Boost.Multiprecision, by every kind of response: they end where those in double do, but for the
# digits that double has not. Without optimisation, since g++ refuses them with it (collision/check.hpp says why).
#
# usage: big_numbers.sh <folder of the project>       with CXX and ANSATZ_SCRATCH in the environment, as ctest sets them
set -euo pipefail
project=$(cd "${1:-$(dirname "${BASH_SOURCE[0]}")/../..}" && pwd)
source "$project/tests/programs.bash"

compile "$CXX" "$project/tests/collision/programs/big_numbers.cpp" big_numbers -O0
./big_numbers
