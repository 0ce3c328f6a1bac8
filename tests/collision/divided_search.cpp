// SPDX-License-Identifier: BSL-1.0
// The pairs of a world with an Execution are searched and tested in shares: its contacts, and so all of its bits, are
// those of a serial search.
// Runs long with the sanitizers.

#include <ansatz/collision.hpp>
#include <ansatz/collision/divided_search.hpp>
#include <ansatz/world.hpp>

#include "tests/catch.hpp"

#include <cmath>
#include <exception>
#include <stdexcept>
#include <thread>
#include <vector>

using namespace ansatz;

namespace {

/// Ranges as no thread would take them: a few rows each, the last ones first, and half of each on another thread.
struct Backwards {
    using role = roles::Execution;
    std::size_t few = 3;
    void execute(std::size_t count, std::size_t, const auto& loop) const {
        for (std::size_t end = count; end > 0;) {
            const std::size_t begin = end > few ? end - few : 0, middle = begin + (end - begin) / 2;
            std::exception_ptr thrown, thrown_there;
            const auto run = [&loop](std::size_t first, std::size_t last, std::exception_ptr& caught) {
                try {
                    if (first < last) loop(first, last);
                } catch (...) {
                    caught = std::current_exception();
                }
            };
            std::thread other([&] { run(middle, end, thrown_there); });
            run(begin, middle, thrown);
            other.join();
            for (const auto& one : {thrown, thrown_there})
                if (one) std::rethrow_exception(one);
            end = begin;
        }
    }
};
/// Which bodies are tested; throws for one of them, once it is told to.
struct Picky {
    using role = roles::Filter;
    using reads = Columns<Position>;
    template <class S> struct In {
        explicit In(const Picky&) {}
        bool passes(const auto& a, const auto& b) const {
            const auto of = [](const auto& row) { return row.template get<Position>().value()[0]; };
            if (of(a) > 1e6 || of(b) > 1e6) throw std::runtime_error("too far");
            return std::fmod(std::abs(of(a) + of(b)), 4) < 3; // the same for (b, a)
        }
    };
};

/// Spheres of several sizes that move, some of them sensors, some fixed, and some points without a shape.
template <class World_> void add_gas(World_& world, int n) {
    constexpr int dimension = World_::composition::S::dimension;
    for (int i = 0; i < n; ++i) {
        const double t = i, size = i % 50 == 0 ? 3 : i % 9 == 0 ? 1.1 : 0.5;
        const auto at = [&](double y, double z) {
            if constexpr (dimension == 2) return metres(1.3 * (i % 40), y);
            else return metres(1.3 * (i % 20), y, z);
        };
        const auto x = position(at(1.2 * (i / 40) + 0.3 * std::sin(t), 1.25 * (i / 20 % 9) + 0.2 * std::cos(2 * t)));
        if (i % 31 == 0) world.add(shapeless, x, mass(1.0 * kilogram));
        else if (i % 23 == 0) world.add(Sphere{size * metre}, x, fixed);
        else {
            const auto v = velocity([&] {
                if constexpr (dimension == 2) return metres_per_second(std::cos(t), -std::sin(3 * t));
                else return metres_per_second(std::cos(t), -std::sin(3 * t), std::sin(5 * t));
            }());
            const auto m = mass((1 + 0.1 * (i % 7)) * kilogram);
            if (i % 11 == 0) world.add(Sphere{size * metre}, x, v, m, sensor);
            else world.add(Sphere{size * metre}, x, v, m);
        }
    }
}
template <class World_> void add_pile(World_& world, int n) {
    world.add(Plane::ground(), fixed);
    for (int i = 0; i < n; ++i)
        world.add(Sphere{0.5 * metre}, mass((1.0 + i % 3) * kilogram),
                  position(metres(1.02 * (i % 9), 0.5 + 0.98 * (i / 81), 1.02 * (i / 9 % 9) + 0.01 * (i % 2))));
}

/// Both worlds, step by step; some bodies go, and come, meanwhile.
void same_bits(int steps, const auto& fill, const auto&... policies) {
    World serial{policies...};
    World divided{policies..., Backwards{}};
    fill(serial), fill(divided);
    std::size_t contacts = 0;
    for (int i = 0; i < steps; ++i) {
        const auto dt = (1.0 + 0.1 * (i % 3)) / 100 * second;
        serial.step(dt), divided.step(dt);
        contacts += serial.contacts().size();
        REQUIRE(divided.contacts().size() == serial.contacts().size());
        REQUIRE(divided.hash() == serial.hash());
        if (i % 4 == 3) {
            const auto gone = serial.handles()[serial.size() / 2];
            serial.remove(gone), divided.remove(gone);
        }
    }
    CHECK(contacts > 20 * std::size_t(steps)); // or it would say nothing
}

} // namespace

TEST_CASE("A grid that is searched in shares, with a filter", "[collision][threads]") {
    same_bits(
        12, [](auto& world) { add_gas(world, 700); }, Space<float, 2>{}, SemiImplicitEuler{}, Picky{}, UniformGrid{},
        Narrowphase<Sphere>{}, Impulse{});
}
TEST_CASE("A broadphase whose pairs are tested in shares, for contacts of the next step", "[collision][threads]") {
    same_bits(
        12, [](auto& world) { add_gas(world, 500); }, Verlet{}, Gravity{}, Octree<SortAndSweep>{},
        Narrowphase<Sphere>{}, Penalty{});
}
TEST_CASE("Pairs that are kept, tested in shares, in substeps and with bodies at rest", "[collision][threads]") {
    same_bits(
        80, [](auto& world) { add_pile(world, 250); }, Space<float, 3>{}, SemiImplicitEuler{}, Gravity{}, Rest{},
        Coherent{}, Narrowphase<Sphere, Plane>{}, SoftSubsteps<Coloured>{});
}
TEST_CASE("Swept bodies, tested in shares", "[collision][threads]") {
    same_bits(
        12, [](auto& world) { add_gas(world, 400); }, SemiImplicitEuler{}, Gravity{}, Picky{},
        UniformGrid<SortAndSweep>{}, Swept<Narrowphase<Sphere>>{}, Impulse{});
}
TEST_CASE("Contacts that are answered as one, with those that nearly touch, tested in shares", "[collision][threads]") {
    same_bits(
        20, [](auto& world) { add_pile(world, 250); }, SemiImplicitEuler{}, Gravity{}, UniformGrid{},
        Narrowphase<Sphere, Plane>{}, Impulse{}, Projection{});
}
TEST_CASE("What a filter throws on a thread leaves the step; the copy of before goes on", "[collision][threads]") {
    World world{Space<float, 2>{},     SemiImplicitEuler{}, Picky{},    UniformGrid{},
                Narrowphase<Sphere>{}, Impulse{},           Backwards{}};
    add_gas(world, 300);
    world.step(0.01 * second);
    auto copy = world, other = world;
    const auto moving = copy.handles()[1];
    for (const auto at : {0.0, 0.9}) copy.add(Sphere{1.0 * metre}, position(metres(2e6 + at, 0)), mass(1.0 * kilogram));
    CHECK_THROWS_WITH(copy.step(0.01 * second), "too far");
    copy = other;
    copy.step(0.01 * second), world.step(0.01 * second);
    CHECK(copy.hash() == world.hash());
    CHECK(copy.position(moving) == world.position(moving));
}
