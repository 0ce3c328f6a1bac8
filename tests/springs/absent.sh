#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
#
# A world without springs is, byte for byte, that of a program which never heard of them: the same source with and without
# #include <ansatz/springs.hpp> gives the same machine code, and no symbol in it is about springs. So that this means
# something, the same search must find them in a program that has a spring.
#
# usage: absent.sh <folder of the project>       with CXX and ANSATZ_SCRATCH in the environment, as ctest sets them
set -euo pipefail
project=$(cd "${1:-$(dirname "${BASH_SOURCE[0]}")/../..}" && pwd)
source "$project/tests/programs.bash"    # launcher
if ! command -v nm > /dev/null || ! command -v objdump > /dev/null; then
    echo "skipped: no nm or objdump (on Debian: apt install binutils)"
    exit
fi
scratch=${ANSATZ_SCRATCH:-$(mktemp -d)}
mkdir -p "$scratch"
cd "$scratch"

program() {    # <its includes> <more policies> <more in the world>
    cat << END
$1
#include <ansatz/world.hpp>
using namespace ansatz;
unsigned long long run() {
    World world{SemiImplicitEuler{}, Gravity{}, Drag{}, Rest{}, Keep<InverseMass>{}$2};
    const auto body = world.add(position(metres(0, 10, 0)), velocity(metres_per_second(1, 0, 0)), mass(1.0 * kilogram));
    $3
    for (int i = 0; i < 60; ++i) world.step(1.0 / 60 * second);
    world.apply_impulse(body, newton_seconds(1, 2, 3));
    return world.hash() + sizeof(world);
}
END
}
program '' '' '' > without.cpp
program '#include <ansatz/springs.hpp>' '' '' > unused.cpp
program '#include <ansatz/springs.hpp>' ', Springs{}' 'world.add(Spring{body, metres(0, 9, 0), 1.0 * newton_per_metre});' > used.cpp
eigen=$(pkg-config --cflags eigen3 2> /dev/null || echo -I/usr/include/eigen3)
about_springs() { nm -C "$1" | grep -cE 'Spring|Rope|Element|Network|ImplicitSystem|StepLimit' || true; }
for name in without unused used; do
    # shellcheck disable=SC2086
    "${launcher[@]}" "${CXX:-g++}" -std=c++20 -MD -O2 -I"$project/include" $eigen -c "$name.cpp" -o "$name.o"
    # The bytes of every section, without the name of the file.
    objdump -s "$name.o" | tail -n +4 > "$name.bytes"
done
[ "$(about_springs used.o)" -gt 0 ] || { echo "the search finds no springs where there are some"; exit 1; }
[ "$(about_springs unused.o)" -eq 0 ] || { echo "symbols about springs in a world without them:"; nm -C unused.o | grep -E 'Spring|Rope|Element|Network|ImplicitSystem|StepLimit'; exit 1; }
cmp without.bytes unused.bytes || { echo "including springs.hpp changed the machine code of a world without springs"; exit 1; }
cmp -s without.bytes used.bytes && { echo "the comparison sees no difference where there is one"; exit 1; }
echo "the same $(grep -c '^ ' without.bytes) lines of machine code, no symbol about springs"
