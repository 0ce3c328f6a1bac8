#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
# Measures time.
#
# What a program with one world costs, and one whose bodies collide, beside including Eigen/Core and Boost.Units SI alone,
# with the compiler of the build. tools/compile_time has the bounds and measures, as the compiler's own CPU time, in turn,
# three times, and more often while a bound does not hold.
#
# usage: compile_time.sh <folder of the project>       with CXX in the environment, as ctest sets it
set -euo pipefail
COMPILERS=${CXX:-c++} exec "$1/tools/compile_time" 3
