#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
#
# A warm broadphase allocates nothing: one that has seen a scene of moving bodies finds the pairs of the same bodies, moved
# on, without operator new.
#
# usage: broadphase_allocation.sh <folder of the project>    with CXX and ANSATZ_SCRATCH in the environment, as ctest sets them
set -euo pipefail
project=$(cd "${1:-$(dirname "${BASH_SOURCE[0]}")/../..}" && pwd)
scratch=${ANSATZ_SCRATCH:-$(mktemp -d)}
mkdir -p "$scratch"
cd "$scratch"

cat > allocation.cpp << 'END'
#include "tests/collision/broadphase/scenes.hpp"

#include <cstdio>
#include <cstdlib>
#include <new>

static bool forbidden = false;
void* operator new(std::size_t size) {
    if (forbidden) std::puts("operator new was called"), std::exit(1);
    if (void* p = std::malloc(size)) return p;
    throw std::bad_alloc();
}
void operator delete(void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }

using namespace broadphase_tests;

template <class S> void steps_of_all(const char* space) {
    each_policy([&](const char* name, const auto& policy) {
        typename std::remove_cvref_t<decltype(policy)>::template In<S> bound(policy);
        for (const std::uint64_t seed : {4u, 9u, 14u, 19u}) { // 400 bodies: uniform, clustered, in a column, of mixed radii
            const auto scene = seeded_scene(seed);
            auto boxes = boxes_of<S>(scene);
            std::size_t pairs = 0;
            for (int step = 0; step < 60; ++step) {
                for (std::size_t i = 0; i < scene.boxes.size(); ++i) { // each swings about its place
                    auto moved = scene.boxes[i];
                    for (std::size_t k = 0; k < 3; ++k) {
                        const double by = 0.2 * std::sin(0.7 * step + double(i + k));
                        moved.lower[k] += by, moved.upper[k] += by;
                    }
                    Vector<typename S::Scalar, S::dimension> low, high;
                    for (int k = 0; k < S::dimension; ++k)
                        low[k] = typename S::Scalar(moved.lower[std::size_t(k)]), high[k] = typename S::Scalar(moved.upper[std::size_t(k)]);
                    boxes.set(i, S::Position::from_value(low), S::Position::from_value(high));
                }
                forbidden = step >= 20;
                bound.find(boxes, [&](std::size_t, std::size_t) { ++pairs; });
                forbidden = false;
            }
            if (pairs == 0) std::puts("no pairs: the case has lost its point"), std::exit(1);
        }
        std::printf("%s, %s: nothing allocated\n", name, space);
    });
}

int main() {
    steps_of_all<Space<>>("space");
    steps_of_all<Space<float, 2>>("plane");
}
END
# -Wno-mismatched-new-delete: g++ sees free() where it has inlined the delete above and not the new
warnings=()
"${CXX:-g++}" -Wno-mismatched-new-delete -E -x c++ /dev/null > /dev/null 2>&1 && warnings=(-Wno-mismatched-new-delete -Wno-unknown-warning-option)
eigen=$(pkg-config --cflags eigen3 2> /dev/null || echo -I/usr/include/eigen3)
# shellcheck disable=SC2086
"${CXX:-g++}" -std=c++20 -O1 "${warnings[@]}" -I"$project" -I"$project/include" $eigen allocation.cpp -o allocation
./allocation
