#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
#
# Who includes single headers and asks a world.query() without that of the answer reads which one to include. Not among
# tests/must_not_compile, where one precompiled header holds the whole library.
#
# usage: query_not_included.sh <folder of the project>       with CXX and ANSATZ_SCRATCH in the environment, as ctest sets them
set -euo pipefail
export LC_ALL=C
project=$(cd "${1:-$(dirname "${BASH_SOURCE[0]}")/../..}" && pwd)
scratch=${ANSATZ_SCRATCH:-$(mktemp -d)}
mkdir -p "$scratch"
cd "$scratch"

asks() {    # <more includes>
    cat << END
#include <ansatz/collision/broadphase/all_pairs.hpp>
#include <ansatz/collision/module.hpp>
#include <ansatz/collision/narrowphase/narrowphase.hpp>
#include <ansatz/collision/response/projection.hpp>
#include <ansatz/collision/sphere.hpp>
#include <ansatz/motion/integrators/semi_implicit_euler.hpp>
#include <ansatz/world/world.hpp>
$1
using namespace ansatz;
int main() {
    World world{SemiImplicitEuler{}, AllPairs{}, Narrowphase<Sphere>{}, Projection{}};
    world.query();
}
END
}
eigen=$(pkg-config --cflags eigen3 2> /dev/null || echo -I/usr/include/eigen3)
compile() { "${CXX:-g++}" -std=c++20 -fsyntax-only -I"$project/include" $eigen "$1" 2> "$1.said"; }

asks '#include <ansatz/collision/queries_in_world.hpp>' > with.cpp
asks '' > without.cpp
if ! compile with.cpp; then
    echo "with the header it does not compile:"
    head -20 with.cpp.said
    exit 1
fi
if compile without.cpp; then
    echo "without the header it compiles: the answer has become a part of another header, and this test means nothing"
    exit 1
fi
if ! grep -m 1 'error' without.cpp.said | grep -qF 'Ansatz: query: what answers it is not included; write #include <ansatz/collision/queries_in_world.hpp>'; then
    echo "the first error is not the sentence that says which header to include:"
    grep -m 3 'error' without.cpp.said
    exit 1
fi
echo "who asks without the header reads which one to include"
