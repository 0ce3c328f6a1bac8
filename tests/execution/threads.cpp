// SPDX-License-Identifier: BSL-1.0
// Threads: a world comes to the same bits on any number of threads.

#include <ansatz/collision.hpp>
#include <ansatz/execution/threads.hpp>
#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

#include "tests/catch.hpp"

#include <oneapi/tbb/global_control.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <thread>
#include <vector>

using namespace ansatz;
using Catch::Matchers::Message;

namespace {

/// A chain of bodies, each moving its own way, with springs between neighbours and across.
template <class World_> void add_chain(World_& world, int n) {
    std::vector<Handle> all;
    for (int i = 0; i < n; ++i)
        all.push_back(world.add(position(metres(i, 3 * std::sin(i), std::cos(3 * i))),
                                mass((1 + 0.01 * (i % 17)) * kilogram),
                                velocity(metres_per_second(std::cos(i), 2 - 0.1 * i, std::sin(2 * i)))));
    for (int i = 1; i < n; ++i) {
        world.add(Spring{all[std::size_t(i)], all[std::size_t(i - 1)], 50.0 * newton_per_metre});
        if (i > 40) world.add(Spring{all[std::size_t(i)], all[std::size_t(i - 40)], 20.0 * newton_per_metre});
    }
}
template <class World_> std::uint64_t run(World_ world, int bodies) {
    add_chain(world, bodies);
    for (int i = 0; i < 8; ++i) world.step((1.0 + 0.1 * (i % 3)) / 200 * second);
    CHECK(world.status().ok());
    return world.hash();
}

/// A law that throws for one body, once it is told to.
struct Failing {
    using role = roles::Force;
    using reads = Columns<Position>;
    template <class S> struct In {
        explicit In(const Failing&) {}
        typename S::Acceleration acceleration(const typename S::Position& x, const auto&) const {
            if (x.value()[0] > 1500) throw std::runtime_error("too far");
            return {};
        }
    };
};

} // namespace

TEST_CASE("Threads change no bit of a chain of springs, and no more of free flight", "[execution]") {
    // oneTBB starts no more threads than there are cores, unless it is told.
    const oneapi::tbb::global_control more(oneapi::tbb::global_control::max_allowed_parallelism, 4);
    const int bodies = GENERATE(0, 1, 7, 300, 4001);
    const auto serial = run(World{SemiImplicitEuler{}, Gravity{}, Springs{}}, bodies);
    for (const int threads : {1, 2, 3, 4}) {
        INFO(threads << " threads, " << bodies << " bodies");
        CHECK(run(World{SemiImplicitEuler{}, Gravity{}, Springs{}, Threads{threads}}, bodies) == serial);
    }
}

TEST_CASE("Threads change no bit of a pile whose contacts are solved by colours", "[execution]") {
    const oneapi::tbb::global_control more(oneapi::tbb::global_control::max_allowed_parallelism, 4);
    const int bodies = GENERATE(30, 5000);
    const auto pile = [&](auto... execution) {
        World world{Space<float, 3>{}, SemiImplicitEuler{},          Gravity{},
                    UniformGrid{},     Narrowphase<Sphere, Plane>{}, SoftSubsteps<Coloured>{},
                    execution...};
        world.add(Plane::ground(), fixed);
        for (int i = 0; i < bodies; ++i)
            world.add(Sphere{0.5 * metre}, mass((1.0 + i % 3) * kilogram),
                      position(metres(0.99 * (i % 20), 0.5 + 0.98 * (i / 400), 0.99 * (i / 20 % 20) + 0.01 * (i % 2))));
        for (int i = 0; i < 8; ++i) world.step(1.0 / 60 * second);
        CHECK(world.status().ok());
        CHECK(world.contacts().size() > std::size_t(bodies));
        return world.hash();
    };
    const auto serial = pile();
    for (const int threads : {1, 2, 3, 4}) {
        INFO(threads << " threads, " << bodies << " bodies");
        CHECK(pile(Threads{threads}) == serial);
    }
}

TEST_CASE("Threads divide what is long, and leave alone what is short", "[execution]") {
    const oneapi::tbb::global_control more(oneapi::tbb::global_control::max_allowed_parallelism, 3);
    const Threads three(3);
    CHECK(three.threads() == 3);
    for (const std::size_t count :
         {std::size_t(0), std::size_t(1), std::size_t(63), std::size_t(64), std::size_t(1000)}) {
        std::vector<std::atomic<int>> touched(count);
        std::atomic<int> parts = 0;
        three.execute(count, 64, [&](std::size_t begin, std::size_t end) {
            ++parts;
            for (std::size_t i = begin; i < end; ++i) ++touched[i];
        });
        INFO(count << " rows");
        for (const auto& once : touched) REQUIRE(once == 1);
        if (count <= 64) CHECK(parts == (count > 0 ? 1 : 0));
        else CHECK(parts > 1);
    }
}

TEST_CASE("What a law throws leaves the step", "[execution]") {
    World world{SemiImplicitEuler{}, Failing{}, Threads{2}};
    for (int i = 0; i < 2000; ++i) world.add(position(metres(i, 0, 0)));
    CHECK_THROWS_WITH(world.step(0.01 * second), "too far");
}

TEST_CASE("Copies of a world share threads, and step at the same time", "[execution]") {
    World world{SemiImplicitEuler{}, Gravity{}, Springs{}, Threads{2}};
    add_chain(world, 2501);
    auto copy = world;
    const auto go = [](auto& one) {
        for (int i = 0; i < 20; ++i) one.step(0.001 * second);
    };
    std::thread other([&] { go(copy); });
    go(world);
    other.join();
    CHECK(copy.hash() == world.hash());
}

TEST_CASE("A number of threads below one is refused", "[execution]") {
    for (const int none : {0, -1})
        CHECK_THROWS_MATCHES(
            Threads{none}, std::invalid_argument,
            Message("Threads: threads is " + std::to_string(none) + "; it is 1 or more; Threads{} takes every core"));
    CHECK(Threads{}.threads() >= 1);
}

TEST_CASE("Any number of threads may be asked for", "[execution]") {
    const Threads many(std::numeric_limits<int>::max());
    CHECK(many.threads() == std::numeric_limits<int>::max());
    std::atomic<std::size_t> rows = 0;
    many.execute(1000, 64, [&](std::size_t begin, std::size_t end) { rows += end - begin; });
    CHECK(rows == 1000);
}
