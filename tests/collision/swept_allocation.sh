#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
#
# A warm world with Swept allocates nothing in a step full of impacts, and a query nothing when the caller's vector has room.
#
# usage: swept_allocation.sh <folder of the project>    with CXX and ANSATZ_SCRATCH in the environment, as ctest sets them
set -euo pipefail
project=$(cd "${1:-$(dirname "${BASH_SOURCE[0]}")/../..}" && pwd)
scratch=${ANSATZ_SCRATCH:-$(mktemp -d)}
mkdir -p "$scratch"
cd "$scratch"

cat > allocation.cpp << 'END'
#include <ansatz/collision.hpp>
#include <ansatz/motion.hpp>
#include <ansatz/world.hpp>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <new>

static bool forbidden = false;
void* operator new(std::size_t size) {
    if (forbidden) std::puts("operator new was called"), std::exit(1);
    if (void* p = std::malloc(size)) return p;
    throw std::bad_alloc();
}
void* operator new(std::size_t size, std::align_val_t alignment) {
    if (forbidden) std::puts("operator new was called"), std::exit(1);
    if (void* p = std::aligned_alloc(std::size_t(alignment), (size + std::size_t(alignment) - 1) / std::size_t(alignment) * std::size_t(alignment))) return p;
    throw std::bad_alloc();
}
void operator delete(void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
void operator delete(void* p, std::align_val_t) noexcept { std::free(p); }
void operator delete(void* p, std::size_t, std::align_val_t) noexcept { std::free(p); }

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, Gravity{}, Impulse<>{}, Projection{}, SortAndSweep{}, Swept<Narrowphase<Sphere, Plane, Box>>{}};
    for (int k = 0; k < 3; ++k)
        for (const int side : {-1, 1}) {
            Eigen::Vector3d n = Eigen::Vector3d::Zero();
            n[k] = -side;
            world.add(Plane{n, -10.0 * metre}, fixed);
        }
    world.add(Box{metres(2, 0.05, 2)}, fixed);
    for (int i = 0; i < 300; ++i) {
        const auto wave = [&](double by) { return std::sin(by * (i + 1)); };
        world.add(Sphere{0.3 * metre}, position(metres(9 * wave(1.1), 9 * wave(1.7), 9 * wave(2.3))), velocity(metres_per_second(150 * wave(3.1), 150 * wave(3.7), 150 * wave(4.3))),
                  mass(1.0 * kilogram), restitution(1));
    }
    std::vector<RayHit<Space<>>> hits;
    std::vector<Handle> bodies;
    hits.reserve(400), bodies.reserve(400);
    std::size_t contacts = 0, asked = 0;
    for (int step = 0; step < 900; ++step) {
        forbidden = step >= 600; // by then its lists are as long as they get
        world.step(1.0 / 60 * second);
        const Ray ray{metres(-10, 0.1 * (step % 9), 0), Eigen::Vector3d(1, 0, 0)};
        world.query().all(ray, hits);
        asked += hits.size() + std::size_t(world.query().closest(ray).has_value());
        world.query().overlap(Sphere{3.0 * metre}, metres(0, 3, 0), bodies, with_sensors);
        asked += bodies.size();
        contacts += world.contacts().size();
        forbidden = false;
    }
    if (contacts < 10000 || asked < 2000) std::puts("little happens: the case has lost its point"), std::exit(1);
    std::printf("%zu contacts, %zu answers: nothing allocated\n", contacts, asked);
}
END
# -Wno-mismatched-new-delete: g++ sees free() where it has inlined the delete above and not the new
warnings=()
"${CXX:-g++}" -Wno-mismatched-new-delete -E -x c++ /dev/null > /dev/null 2>&1 && warnings=(-Wno-mismatched-new-delete -Wno-unknown-warning-option)
eigen=$(pkg-config --cflags eigen3 2> /dev/null || echo -I/usr/include/eigen3)
# shellcheck disable=SC2086
"${CXX:-g++}" -std=c++20 -O1 "${warnings[@]}" -I"$project" -I"$project/include" $eigen allocation.cpp -o allocation
./allocation
