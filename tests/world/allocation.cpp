// SPDX-License-Identifier: BSL-1.0
// A step does not allocate: every call of operator new in this executable is counted while a step runs.

#include "tests/catch.hpp"
#include "tests/operator_new.hpp"
#include "tests/world/worlds.hpp"

#include <cstddef>
#include <new>

using namespace ansatz;
using namespace ansatz::test;

namespace {

std::size_t allocations = 0;

/// How often `f` allocates.
template <class F> std::size_t allocations_of(F&& f) {
    allocations = 0;
    before_allocation = [](std::size_t) noexcept { return ++allocations > 0; };
    f();
    before_allocation = nullptr;
    return allocations;
}

template <class W> void fill(W& world) {
    for (int i = 0; i < 8; ++i) {
        world.add(position(metres(i, 0, 0)), velocity(metres_per_second(0.01, 0, 0)),
                  mass(1.0 * kilogram)); // falls asleep
        world.add(position(metres(i, 1, 0)), velocity(metres_per_second(9, 0, 0)), mass(1.0 * kilogram));
        world.add(position(metres(i, 2, 0)), resting, mass(1.0 * kilogram));
        world.add(position(metres(i, 3, 0)), velocity(metres_per_second(1, 0, 0)), moving);
        world.add(position(metres(i, 4, 0)), fixed);
    }
}

/// Steps in which bodies fall asleep and wake, with everything between them that a program does to bodies.
template <class W> std::size_t allocations_of_a_while(W& world, int steps) {
    const auto all = world.handles();
    std::size_t count = 0, slept = 0, woke = 0;
    for (int i = 0; i < steps; ++i)
        count += allocations_of([&] {
            world.apply_force(all[1], newtons(1, 2, 3));
            world.apply_impulse(all[6], newton_seconds(0.1, 0, 0));
            world.set_velocity(all[11], metres_per_second(3, 0, 0));
            if (i % 30 == 29)
                for (const auto h : all) world.wake(h);
            if (i % 30 == 29) world.set_position(all[0], metres(0, 5, 0));
            world.step((i % 5 == 0 ? 1.0 / 120 : 1.0 / 60) * second);
            world.step(0.0 * second);
            (void)world.hash(), (void)world.status(), (void)world.velocity(all[1]), (void)world.acceleration(all[2]);
            for (const auto& e : world.events()) ++(e.kind == Event::Kind::slept ? slept : woke);
        });
    CHECK(slept > 0); // it was not for lack of events
    CHECK(woke > 0);
    return count;
}

} // namespace

TEST_CASE("allocations are counted here", "[world][step]") {
    CHECK(allocations_of([] { ::operator delete(::operator new(8)); }) ==
          1); // by name: a compiler may leave out `delete new int`
    CHECK(allocations_of([] {
              World world{SemiImplicitEuler{}};
              world.add();
          }) > 0);
}

TEMPLATE_TEST_CASE("no step allocates, not even the first, whatever sleeps and wakes", "[world][step]",
                   ANSATZ_INTEGRATORS) {
    World world{
        TestType{},     Later{1.1 * second}, Drag{}, AppliedForces{}, Rest{0.05 * metre_per_second, 0.1 * second},
        Interpolation{}};
    fill(world);
    CHECK(allocations_of_a_while(world, 90) == 0);
}

TEMPLATE_TEST_CASE("no step allocates where bodies couple", "[world][step]", Verlet, RungeKutta4) {
    World world{TestType{},      Nothing{},       Drag{},
                QuadraticDrag{}, AppliedForces{}, Rest{0.05 * metre_per_second, 0.1 * second},
                Interpolation{}};
    fill(world);
    CHECK(allocations_of_a_while(world, 60) == 0);
}

TEST_CASE("a copy makes its room in its first step, and an assigned snapshot needs none", "[world][step]") {
    World world{Verlet{}, AppliedForces{}, Rest{0.05 * metre_per_second, 0.1 * second}};
    fill(world);
    const auto snapshot = world;
    auto copy = snapshot;
    copy.step(1.0 / 60 * second);
    CHECK(allocations_of_a_while(copy, 60) == 0);
    // Rolling back: as a game over a network does it in every frame.
    for (int i = 0; i < 3; ++i) {
        CHECK(allocations_of([&] { world = snapshot; }) == 0);
        CHECK(allocations_of_a_while(world, 60) == 0);
    }
}

TEST_CASE("additions within what was reserved do not allocate", "[world][step]") {
    World world{Verlet{}, AppliedForces{}, Rest{}, Datum<int>{}};
    world.reserve(40);
    CHECK(allocations_of([&] { fill(world); }) == 0);
    const auto all = world.handles();
    CHECK(allocations_of([&] {
              for (const auto h : all) world.remove(h);
              fill(world);
              world.step(1.0 / 60 * second);
          }) == 0);
}
