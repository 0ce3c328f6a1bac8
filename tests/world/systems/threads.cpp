// SPDX-License-Identifier: BSL-1.0
// A policy outside the library, against the public frame only: an execution on std::thread. Whatever runs the loops of
// a step, the world comes to the same bits.
// Runs long with the sanitizers.

#include <ansatz/collision.hpp>
#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

#include "tests/catch.hpp"

#include <cmath>
#include <thread>
#include <vector>

using namespace ansatz;

namespace {

//! [pool of threads]
struct Threads {
    using role = roles::Execution;
    int threads = 2;
    void execute(std::size_t count, std::size_t, const auto& loop) const {
        const auto n = std::size_t(threads);
        std::vector<std::thread> others;
        for (std::size_t i = 1; i < n; ++i)
            others.emplace_back([=, &loop] { loop(i * count / n, (i + 1) * count / n); });
        loop(0, count / n);
        for (auto& other : others) other.join();
    }
};
//! [pool of threads]

/// Bodies here and there, each moving its own way, of different mass.
template <class World_> void add_bodies(World_& world, int n) {
    constexpr int dimension = World_::composition::S::dimension;
    for (int i = 0; i < n; ++i) {
        const double t = i;
        const auto m = mass((1 + 0.01 * (i % 17)) * kilogram);
        if constexpr (dimension == 2)
            world.add(position(metres(t, 3 * std::sin(t))), velocity(metres_per_second(std::cos(t), -0.1 * t)), m);
        else
            world.add(position(metres(t, 3 * std::sin(t), std::cos(3 * t))),
                      velocity(metres_per_second(std::cos(t), 2 - 0.1 * t, std::sin(2 * t))), m);
    }
}
/// A chain of springs between them, every third also at its place, and some across.
template <class World_> void add_springs(World_& world) {
    const auto all = world.handles();
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto stiff = (50.0 + double(i % 7)) * newton_per_metre;
        if (i > 0) world.add(Spring{all[i], all[i - 1], stiff, 0.3 * newton_second_per_metre});
        if (i % 3 == 0) world.add(Spring{all[i], world.position(all[i]), stiff, 0.1 * newton_second_per_metre});
        if (i > 40) world.add(Spring{all[i - 40], all[i], 0.5 * stiff, 0.1 * newton_second_per_metre});
    }
}
template <class World_> void add_pile(World_& world, int n) {
    world.add(Plane::ground(), fixed);
    for (int i = 0; i < n; ++i)
        world.add(Sphere{0.5 * metre}, mass((1.0 + i % 3) * kilogram),
                  position(metres(1.05 * (i % 9), 0.5 + 0.98 * (i / 81), 1.05 * (i / 9 % 9) + 0.01 * (i % 2))));
}

template <class World_> auto run(World_ world, auto&& fill, int steps) {
    fill(world);
    for (int i = 0; i < steps; ++i) world.step((1.0 + 0.1 * (i % 3)) / 100 * second);
    std::vector<decltype(world.position(Handle{}))> places;
    for (const auto handle : world.handles()) places.push_back(world.position(handle));
    CHECK(world.status().ok());
    return std::pair(world.hash(), places);
}
/// The same with none and with one to three threads.
void same_bits(int steps, auto&& fill, const auto&... policies) {
    const auto serial = run(World{policies...}, fill, steps);
    for (const int threads : {1, 2, 3}) {
        INFO(threads << " threads, " << serial.second.size() << " bodies");
        const auto divided = run(World{policies..., Threads{threads}}, fill, steps);
        CHECK(divided.first == serial.first);
        CHECK(divided.second == serial.second);
    }
}

} // namespace

TEST_CASE("Free flight is the same to the bit on any number of threads", "[systems][threads]") {
    const int bodies = GENERATE(0, 1, 7, 1001);
    same_bits(
        5, [&](auto& world) { add_bodies(world, bodies); }, Space<float, 2>{}, RungeKutta4{}, Gravity{},
        Drag{0.05 / second}, QuadraticDrag{0.01 * kilogram_per_metre});
}
TEST_CASE("Springs are the same to the bit on any number of threads", "[systems][threads]") {
    const int bodies = GENERATE(0, 1, 7, 2501);
    const auto fill = [&](auto& world) {
        add_bodies(world, bodies);
        add_springs(world);
    };
    same_bits(5, fill, SemiImplicitEuler{}, Gravity{}, Springs{});
    same_bits(5, fill, Verlet{}, Gravity{}, Drag{0.05 / second}, Springs{});
}
TEST_CASE("A pile that comes to rest is the same to the bit on any number of threads", "[systems][threads]") {
    const int bodies = GENERATE(0, 1, 7, 201);
    same_bits(
        60, [&](auto& world) { add_pile(world, bodies); }, SemiImplicitEuler{}, Gravity{}, Rest{}, UniformGrid{},
        Narrowphase<Sphere, Plane>{}, SoftSubsteps{});
}
TEST_CASE("A pile by colours is the same to the bit on any number of threads", "[systems][threads]") {
    const int bodies = GENERATE(0, 1, 201, 2301); // the last in three groups, and those between them
    const auto fill = [&](auto& world) { add_pile(world, bodies); };
    same_bits(8, fill, Space<float, 3>{}, SemiImplicitEuler{}, Gravity{}, Coherent{}, Narrowphase<Sphere, Plane>{},
              SoftSubsteps<Coloured>{});
    same_bits(8, fill, Verlet{}, Gravity{}, Rest{}, UniformGrid{}, Narrowphase<Sphere, Plane>{},
              SoftSubsteps<Coloured, Friction>{});
}
TEST_CASE("Two copies of a world step at the same time", "[systems][threads]") {
    World world{
        Space<float, 2>{}, RungeKutta4{}, Gravity{}, Drag{0.05 / second}, QuadraticDrag{0.01 * kilogram_per_metre},
        Threads{3}};
    add_bodies(world, 101);
    auto copy = world;
    const auto go = [](auto& one) {
        for (int i = 0; i < 20; ++i) one.step(0.01 * second);
    };
    std::thread other([&] { go(copy); });
    go(world);
    other.join();
    CHECK(copy.hash() == world.hash());
}
