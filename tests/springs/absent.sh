#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
#
# A world without springs is that of a program which never heard of them: the same source with and without
# #include <ansatz/springs.hpp> gives the same instructions and literals, sections of the same length, and no symbol about springs.
#
# usage: absent.sh <folder of the project>       with CXX and ANSATZ_SCRATCH in the environment, as ctest sets them
# shellcheck source=/dev/null
. "$(dirname "${BASH_SOURCE[0]}")/../absent.bash" "$@"

plain '#include <ansatz/springs.hpp>' ', Springs{}' \
    'world.add(Spring{body, metres(0, 9, 0), 1.0 * newton_per_metre});' > used.cpp
object used -O0
never_heard_of springs 'Springs?|Rope\w*|Element\w*|Network\w*|ImplicitSystem\w*|StepLimit\w*'
echo "the same instructions and sizes in $(wc -l < without.bytes) functions and sections, no symbol about springs"
