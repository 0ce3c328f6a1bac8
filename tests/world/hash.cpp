// SPDX-License-Identifier: BSL-1.0
// The hash of a state: equal states have equal hashes, and one bit of anything in it changes it.

#include <ansatz/world/hash.hpp>

#include "tests/catch.hpp"
#include "tests/world/lives.hpp"

#include <bit>
#include <cstdint>
#include <limits>
#include <set>

using namespace ansatz;
using namespace ansatz::test;

namespace {

std::uint64_t hash_of(std::initializer_list<double> numbers) {
    StateHash hash;
    for (const double x : numbers) hash.add_number(x);
    return hash.value();
}

template <class Scalar> using Bits = std::conditional_t<sizeof(Scalar) == 4, std::uint32_t, std::uint64_t>;

/// Turns over one bit in the storage of a world, past its door.
template <class C, class W> void flip(W& world, std::size_t slot, int component, int bit) {
    using Scalar = typename W::Scalar;
    auto& place = const_cast<Scalar&>(world.template lane<C>(component)[slot]);
    place =
        std::bit_cast<Scalar>(static_cast<Bits<Scalar>>(std::bit_cast<Bits<Scalar>>(place) ^ (Bits<Scalar>(1) << bit)));
}

/// Turns over every bit of a state column, one after the other, and counts those whose change the hash does not show.
template <class C, class W> int bits_not_seen(W world) {
    using Scalar = typename W::Scalar;
    const auto before = world.hash();
    int unseen = 0;
    for (std::size_t slot = 0; slot < world.size(); ++slot)
        for (int k = 0; k < int(lanes_of<C>(W::S::dimension)); ++k) {
            const Scalar value = world.template lane<C>(k)[slot];
            for (int bit = 0; bit < int(8 * sizeof(Scalar)); ++bit) {
                flip<C>(world, slot, k, bit);
                const Scalar changed = world.template lane<C>(k)[slot];
                const bool zeros = value == 0 && changed == 0; // the one change that is none, by value
                if ((world.hash() == before) != zeros) ++unseen;
                flip<C>(world, slot, k, bit);
            }
        }
    CHECK(world.hash() == before);
    return unseen;
}

} // namespace

TEST_CASE("numbers are hashed by value: both zeros are one, all NaNs are one, a float is the double it is",
          "[world][hash]") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(hash_of({0.0}) == hash_of({-0.0}));
    CHECK(hash_of({nan}) == hash_of({-nan}));
    CHECK(hash_of({nan}) == hash_of({std::bit_cast<double>(std::uint64_t(0x7ff0000000000001u))}));
    CHECK(hash_of({nan}) != hash_of({std::numeric_limits<double>::infinity()}));
    CHECK(hash_of({0.0}) != hash_of({std::numeric_limits<double>::denorm_min()}));
    StateHash narrow, wide;
    narrow.add_number(0.1f);
    wide.add_number(double(0.1f));
    CHECK(narrow.value() == wide.value());
}

TEST_CASE("the order and the number of what is hashed matter", "[world][hash]") {
    CHECK(hash_of({1, 2}) != hash_of({2, 1}));
    CHECK(hash_of({1}) != hash_of({1, 0}));
    CHECK(hash_of({}) != hash_of({0}));
    CHECK(hash_of({0}) != hash_of({0, 0}));
    std::set<std::uint64_t> seen; // every single bit of a word goes its own way
    for (int bit = 0; bit < 64; ++bit) {
        StateHash hash;
        hash.add(std::uint64_t(1) << bit);
        seen.insert(hash.value());
        hash.add(0);
        seen.insert(hash.value());
    }
    CHECK(seen.size() == 128);
}

TEST_CASE("equal worlds have equal hashes, whatever their capacity and their history of slots", "[world][hash]") {
    auto build = [](bool reserved) {
        World world{SemiImplicitEuler{}, Rest{}};
        if (reserved) world.reserve(1000);
        const auto a = world.add(position(metres(1, 2, 3))), b = world.add(velocity(metres_per_second(1, 0, 0)));
        if (reserved) { // the same state by another way: slots are swapped, the bodies are as they were
            world.set_velocity(a, metres_per_second(1, 1, 1));
            world.set_velocity(a, metres_per_second(0, 0, 0));
        }
        world.set_position(b, metres(4, 5, 6));
        return world;
    };
    CHECK(build(true).hash() == build(false).hash());
    auto minus = build(false);
    minus.set_position(minus.handles()[0], metres(1, 2, 3));
    minus.set_velocity(minus.handles()[0], metres_per_second(-0.0, 0, -0.0));
    CHECK(minus.hash() == build(false).hash()); // by value: +0 is -0
}

TEMPLATE_TEST_CASE("one bit of any column of any body changes the hash", "[world][hash]", SemiImplicitEuler, Verlet) {
    auto world = eventful<Space<float, 2>, TestType>();
    live(world, 0, 30);
    REQUIRE(world.template read<AppliedForce>(world.handles()[1]).value()[0] != 0);
    [&]<class... C>(Columns<C...>) {
        auto check = [&]<class One>(Columns<One>) {
            INFO("column " << One::name);
            CHECK(bits_not_seen<One>(world) == 0);
        };
        (check(Columns<C>{}), ...);
    }(typename decltype(world)::composition::state{});
}

TEST_CASE("two columns, or two bodies, that exchange their values change the hash", "[world][hash]") {
    World world{SemiImplicitEuler{}, Keep<Heat, Home>{}};
    const auto a = world.add(position(metres(1, 2, 3)), velocity(metres_per_second(4, 5, 6)));
    const auto b = world.add(position(metres(4, 5, 6)), velocity(metres_per_second(1, 2, 3)));
    const auto before = world.hash();
    auto exchanged = world;
    exchanged.set_position(a, metres(4, 5, 6));
    exchanged.set_velocity(a, metres_per_second(1, 2, 3));
    CHECK(exchanged.hash() != before);
    exchanged.set_position(b, metres(1, 2, 3));
    exchanged.set_velocity(b, metres_per_second(4, 5, 6));
    CHECK(exchanged.hash() != before);
    auto turned = world; // components
    turned.set_position(a, metres(2, 1, 3));
    CHECK(turned.hash() != before);
}

TEST_CASE("tick, time, step, motion, identity and a start that waits are part of the hash", "[world][hash]") {
    using W = World<Verlet, Rest>;
    W world{Verlet{}, Rest{}};
    const auto body = world.add(position(metres(1, 2, 3)));
    auto changed = [&](auto&& f) {
        W other = world;
        f(other);
        return other.hash() != world.hash();
    };
    CHECK_FALSE(changed([](W&) {}));
    CHECK(changed([](W& w) { w.step(1e-3 * second); }));
    CHECK(changed([](W& w) { w.add(); }));
    CHECK(changed([&](W& w) { w.remove(body); }));
    CHECK(changed([&](W& w) { // the same body again is another one
        w.remove(body);
        w.add(position(metres(1, 2, 3)));
    }));
    // Two ways to the same time by the same last step; only the number of steps differs.
    auto many = W{Verlet{}, Rest{}}, few = many;
    for (const double dt : {1.0 / 64, 1.0 / 64, 1.0 / 32}) many.step(dt * second);
    for (const double dt : {1.0 / 32, 1.0 / 32}) few.step(dt * second);
    CHECK(many.time() == few.time());
    CHECK(many.hash() != few.hash());
    auto slower = W{Verlet{}, Rest{}}, faster = slower;
    for (const double dt : {1.0 / 64, 1.0 / 32}) slower.step(dt * second);
    for (const double dt : {1.0 / 32, 1.0 / 64}) faster.step(dt * second);
    CHECK(slower.time() == faster.time());
    CHECK(slower.hash() != faster.hash()); // the last step's length: history is read with it
    // A body that has stood at (1, 2, 3), and one that was told to go with (1, 2, 3): the same lanes, another meaning.
    World stood{Verlet{}};
    const auto standing = stood.add(position(metres(1, 2, 3)));
    stood.step(1e-3 * second);
    auto goes = stood;
    goes.set_velocity(standing, metres_per_second(1, 2, 3));
    REQUIRE(goes.read<PreviousPosition>(standing) == stood.read<PreviousPosition>(standing));
    CHECK(goes.hash() != stood.hash());
    auto a = W{Verlet{}, Rest{}}, b = a;
    a.add(fixed);
    b.add(moving);
    CHECK(a.hash() != b.hash());
}

TEST_CASE("worlds of equal hash answer the next addition with the same handle", "[world][hash]") {
    World never{SemiImplicitEuler{}};
    auto once = never, twice = never;
    for (auto* w : {&never, &once, &twice}) w->add();
    once.remove(once.add());
    for (int i = 0; i < 2; ++i) twice.remove(twice.add());
    // The directory is state: what it gives out next is not the same in these three.
    CHECK(never.hash() != once.hash());
    CHECK(once.hash() != twice.hash());
    auto ab = once, ba = once;
    const auto a = ab.add(), b = ab.add();
    REQUIRE(ba.add() == a);
    REQUIRE(ba.add() == b);
    ab.remove(a), ab.remove(b);
    ba.remove(b), ba.remove(a);
    CHECK(ab.hash() != ba.hash());
}

TEST_CASE("what a step makes anew is no part of the hash", "[world][hash]") {
    World world{Verlet{}, Nothing{}, QuadraticDrag{}};
    world.add(velocity(metres_per_second(1, 2, 3)), mass(1.0 * kilogram));
    world.step(1.0 / 60 * second);
    const auto before = world.hash();
    flip<Velocity>(world, 0, 0, 40); // stored as scratch, derived before it is used
    CHECK(world.hash() == before);
    flip<PreviousPosition>(world, 0, 0, 40);
    CHECK(world.hash() != before);
}
