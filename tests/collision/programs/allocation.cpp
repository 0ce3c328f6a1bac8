// SPDX-License-Identifier: BSL-1.0
// Warm worlds in which spheres and boxes fall, bounce and come to rest. The script of this name says what it shows.
#define EIGEN_RUNTIME_NO_MALLOC
#include <cstdio>
#include <cstdlib>
#define eigen_assert(ok) ((ok) ? (void)0 : (std::puts("Eigen allocated: " #ok), std::exit(1)))
#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

#include "tests/operator_new.hpp"

/// While this holds, an allocation ends the program.
static bool forbidden = false;
static int step_now = 0;
static const char* case_now = "";
/// How many there were.
static int allocations = 0;
static bool allowed(std::size_t) noexcept {
    ++allocations;
    if (forbidden) std::printf("%s: operator new was called in step %d\n", case_now, step_now), std::exit(1);
    return true;
}

using namespace ansatz;

/// Spheres and boxes fall into a heap, are thrown up again and again, and come to rest where they may.
template <class... P> void pile(const char* name, P... policies) {
    case_now = name;
    World world{Gravity{}, Narrowphase<Sphere, Plane, Box>{}, policies...};
    world.add(Plane::ground(), fixed);
    world.add(Box{metres(3, 0.5, 3)}, position(metres(0, 0.5, 0)), fixed, sensor);
    for (const double side : {-1.0, 1.0}) {
        world.add(Plane{Eigen::Vector3d(side, 0, 0), -1.0 * metre}, fixed);
        world.add(Plane{Eigen::Vector3d(0, 0, side), -1.0 * metre}, fixed);
    }
    std::vector<Handle> balls;
    for (int i = 0; i < 60; ++i) {
        const auto at =
            position(metres(-0.8 + 0.4 * (i % 5) + 0.01 * (i / 5), 0.3 + 0.45 * (i / 20), -0.6 + 0.4 * (i / 5 % 4)));
        balls.push_back(i % 7 == 0 ? world.add(Box{metres(0.15, 0.15, 0.15)}, at, mass(1.0 * kilogram))
                                   : world.add(Sphere{0.2 * metre}, at, mass(1.0 * kilogram)));
        if constexpr (decltype(world)::composition::template stores<Friction>)
            world.template write<Friction>(balls.back(), Quantity<unit::Dimensionless>(0.4));
    }
    const auto beginning = world;
    std::size_t most = 0, ended = 0;
    const auto run = [&](bool strict) {
        for (step_now = 0; step_now < 240; ++step_now) {
            if (step_now % 80 == 79)
                for (const auto ball : balls) world.apply_impulse(ball, newton_seconds(0, 4, 0));
            forbidden = strict;
            Eigen::internal::set_is_malloc_allowed(!strict);
            world.step(1.0 / 120 * second);
            Eigen::internal::set_is_malloc_allowed(true);
            forbidden = false;
            most = std::max(most, world.contacts().size());
            ended += world.contacts_ended().size();
        }
    };
    for (int warm = 0; warm < WARM_UPS; ++warm) {
        run(false);
        world = beginning;
    }
    most = ended = 0;
    run(true);
    if (most < 60 || ended < 20)
        std::printf("%s: only %zu contacts, %zu ended: the case has lost its point\n", name, most, ended), std::exit(1);
    std::printf("%s: up to %zu contacts, %zu ended, nothing allocated\n", name, most, ended);
}

/// A heap that spreads on the ground and falls apart into more islands than ever: what holds one entry for each grows
/// by a share, and not by one.
static void heap_that_falls_apart() {
    World world{SemiImplicitEuler{}, Gravity{}, UniformGrid{}, Narrowphase<Sphere, Plane>{}, SoftSubsteps<>{}};
    constexpr int bodies = 512;
    world.reserve(bodies + 1);
    world.add(Plane::ground(), fixed);
    for (int i = 0; i < bodies; ++i)
        world.add(Sphere{(0.3 + 0.02 * (i % 11)) * metre}, mass(1.0 * kilogram),
                  position(metres(0.9 * (i % 8) + 0.01 * (i % 5), 0.5 + 0.9 * (i / 64), 0.9 * (i / 8 % 8))));
    int steps = 0, most = 0;
    for (step_now = 0; step_now < 600; ++step_now) {
        const int before = allocations;
        world.step(0.01 * second);
        if (step_now >= 200 && allocations > before) ++steps;
        most = std::max(most, int(world.contacts().size()));
    }
    if (steps <= 10 && most > bodies) return;
    std::printf("a heap that falls apart: %d of 400 steps called operator new, with %d contacts at most\n", steps,
                most);
    std::exit(1);
}

/// Balls that come down to the ground, one in each step: lists of contacts grow by a share, those of groups of contacts
/// too, of which there are several among more than 1024 ids. A little gravity presses them on.
template <class Response> void rain(const char* name, Response response) {
    World world{SemiImplicitEuler{}, Gravity{metres_per_second_squared(0, -0.1, 0)}, UniformGrid{},
                Narrowphase<Sphere, Plane>{}, response};
    constexpr int bodies = 1500, falling = 200;
    world.reserve(bodies + 1);
    world.add(Plane::ground(), fixed);
    for (int i = 0; i < bodies; ++i) {
        const int after = i - (bodies - falling); // so many steps of 10 mm
        world.add(Sphere{0.3 * metre}, mass(1.0 * kilogram),
                  position(metres(i % 40, after < 0 ? 0.29 : 0.31 + 0.01 * after, i / 40)),
                  velocity(metres_per_second(0, after < 0 ? 0 : -1, 0)));
    }
    int steps = 0;
    for (step_now = 0; step_now < 150; ++step_now) {
        const int before = allocations;
        world.step(0.01 * second);
        if (step_now >= 50 && allocations > before) ++steps;
    }
    if (steps <= 10 && world.contacts().size() > bodies - falling + 140) return;
    std::printf("rain, %s: %d of 100 steps called operator new, with %zu contacts at the end\n", name, steps,
                world.contacts().size());
    std::exit(1);
}

int main() {
    test::before_allocation = allowed;
    heap_that_falls_apart();
    rain("SoftSubsteps", SoftSubsteps<>{});
    rain("SoftSubsteps<Coloured>", SoftSubsteps<Coloured>{});
    using I = SemiImplicitEuler;
    const auto with = [](const char* name, auto broadphase) { pile(name, I{}, broadphase, Impulse<>{}, Projection{}); };
    with("AllPairs", AllPairs{});
    with("BoundingBoxes", BoundingBoxes{});
    with("SortAndSweep", SortAndSweep{});
    with("UniformGrid", UniformGrid<>{});
    with("UniformGrid<SortAndSweep>", UniformGrid<SortAndSweep>{});
    with("Octree", Octree<>{.threshold = 4});
    with("Octree<SortAndSweep>", Octree<SortAndSweep>{.threshold = 4});
    with("BinarySplit", BinarySplit<>{.threshold = 4});
    pile("Impulse", I{}, SortAndSweep{}, Impulse<>{});
    pile("Impulse<Friction>, Projection, Layers, Rest", I{}, SortAndSweep{}, Impulse<Friction>{.sweeps = 2},
         Projection{}, Layers{}, Rest{});
    pile("Penalty", I{}, SortAndSweep{}, Penalty{2e4 * newton_per_metre, 50.0 * newton_second_per_metre});
    pile("Penalty, Verlet, Rest", Verlet{}, SortAndSweep{},
         Penalty{2e4 * newton_per_metre, 50.0 * newton_second_per_metre}, Rest{});
    pile("Penalty, RungeKutta4", RungeKutta4{}, SortAndSweep{},
         Penalty{2e4 * newton_per_metre, 50.0 * newton_second_per_metre});
    pile("SoftSubsteps", I{}, SortAndSweep{}, SoftSubsteps<>{});
    pile("SoftSubsteps<Friction>, Rest", I{}, SortAndSweep{}, SoftSubsteps<Friction>{}, Rest{});
    pile("SoftSubsteps<Coloured, Friction>, Rest", I{}, UniformGrid<>{}, SoftSubsteps<Coloured, Friction>{}, Rest{});
    pile("SoftSubsteps, Verlet", Verlet{}, UniformGrid<>{}, SoftSubsteps<>{});
}
