#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
#
# A world without water is that of a program which never heard of it: the same source with and without
# #include <ansatz/water.hpp> gives the same instructions and literals, sections of the same length, and no symbol about water.
#
# usage: absent.sh <folder of the project>       with CXX and ANSATZ_SCRATCH in the environment, as ctest sets them
# shellcheck source=/dev/null
. "$(dirname "${BASH_SOURCE[0]}")/../absent.bash" "$@"

plain '#include <ansatz/water.hpp>' ', Pools<WaterColumns>{}, Buoyancy{}' \
    'world.add(Pool{Surface{WaterColumns{3.0 * metre_per_second}, ColumnGrid(20, 20, 1.0 * metre), 2.0 * metre}}); world.add(Floating{body, Sphere{0.5 * metre}});' > used.cpp
object used -O0
# Where a body is added, what g++ finds worth inlining depends on all that the file names: World::add and take are not compared.
never_heard_of water 'Pools?|PoolRow|Water\w*|Surface\w*|ColumnGrid|ColumnAxis|Buoyancy|Floating\w*|Afloat|Ripples?|Waves?|Foam' 'ansatz5WorldI.*E(3add|4take)I'
echo "the same instructions and sizes in $(wc -l < without.compared) functions and sections, no symbol about water"
