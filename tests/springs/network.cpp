// SPDX-License-Identifier: BSL-1.0
// Springs as things of a world: handles, changes at run time, refusals, copies, hashes.

#include <ansatz/springs/network.hpp>
#include <ansatz/springs/spring.hpp>
#include <ansatz/world/element_door.hpp>

#include "tests/springs/support.hpp"

using namespace spring_tests;
using Catch::Matchers::ContainsSubstring;

TEST_CASE("springs are added, read, changed and removed by handles", "[springs]") {
    World world{SemiImplicitEuler{}, Springs{}};
    const auto a = world.add(position(metres(0, 0, 0)), mass(1.0 * kilogram));
    const auto b = world.add(position(metres(0, 3, 4)), mass(1.0 * kilogram));
    const auto first = world.add(Spring{a, b, 10.0 * N_per_m});
    const auto held = world.add(Spring{.first = metres(1, 2, 3),
                                       .second = b,
                                       .stiffness = 20.0 * N_per_m,
                                       .damping = 3.0 * N_s_per_m,
                                       .rest_length = 0.5 * metre});
    CHECK(world.elements<Spring>().size() == 2);
    CHECK(*world.get(first).rest_length == 5.0 * metre); // the distance when it was added
    CHECK(world.get(first).first.body() == a);
    CHECK(world.get(first).second.body() == b);
    CHECK(world.get(held).first.body() == b); // the body stands first
    CHECK(world.get(held).second.is_point());
    CHECK(world.get(held).second.point() == metres(1, 2, 3));
    CHECK(world.get(held).damping == 3.0 * N_s_per_m);

    auto other = world.get(held);
    other.stiffness = 30.0 * N_per_m;
    world.set(held, other);
    CHECK(world.get(held).stiffness == 30.0 * N_per_m);
    CHECK(world.contains(held));

    world.remove(first);
    CHECK_FALSE(world.contains(first));
    CHECK(world.contains(held));
    const auto third = world.add(Spring{a, b, 40.0 * N_per_m});
    CHECK(third.id == first.id); // the place is given again, the handle is another
    CHECK_FALSE(third == first);
    CHECK_THROWS_WITH(world.get(first),
                      ContainsSubstring("World::get: the handle is stale: number 0 of generation 0 was removed"));
    CHECK_THROWS_AS(world.remove(first), std::out_of_range);
    CHECK_THROWS_WITH(world.remove(SpringHandle{}), ContainsSubstring("World::remove: the handle is empty"));
    CHECK_THROWS_WITH(world.set(SpringHandle{17, 0}, other),
                      ContainsSubstring("number 17, but this world has given out only 2"));
}

TEST_CASE("a spring is gone with a body that it holds, and only that one", "[springs]") {
    World world{Verlet{}, Springs{}, Ropes{}};
    std::vector<Handle> b;
    for (int i = 0; i < 4; ++i) b.push_back(world.add(position(metres(i, 0, 0)), mass(1.0 * kilogram)));
    const auto s01 = world.add(Spring{b[0], b[1], 10.0 * N_per_m});
    const auto s12 = world.add(Spring{b[1], b[2], 10.0 * N_per_m});
    const auto r13 = world.add(Rope{b[1], b[3], 10.0 * N_per_m});
    const auto s23 = world.add(Spring{b[2], b[3], 10.0 * N_per_m});
    world.step(0.01 * second);
    world.remove(b[1]);
    CHECK_FALSE(world.contains(s01));
    CHECK_FALSE(world.contains(s12));
    CHECK_FALSE(world.contains(r13));
    CHECK(world.contains(s23));
    world.step(0.01 * second);
    const auto again = world.add(position(metres(9, 0, 0)), mass(1.0 * kilogram));
    CHECK(again.id == b[1].id);
    CHECK(world.elements<Spring>().size() == 1);
    for (int i = 0; i < 10; ++i) world.step(0.01 * second);
    CHECK(world.position(again) == metres(9, 0, 0)); // nothing holds it
    CHECK(world.status().ok());
}

TEST_CASE("what cannot be is refused by name, value and unit, and the world is as it was", "[springs]") {
    World world{SemiImplicitEuler{}, Springs<Breaking>{}, Space<float, 2>{}};
    const auto a = world.add(position(metres(0, 0)), mass(1.0 * kilogram));
    const auto b = world.add(position(metres(1, 0)), mass(1.0 * kilogram));
    const auto kept = world.add(Spring{a, b, 1.0 * N_per_m}, breaks_at(2.0 * newton));
    const auto before = world.hash();
    auto refused = [&](const Spring& spring, const std::string& sentence) {
        CHECK_THROWS_WITH(world.add(spring), ContainsSubstring("World::add: " + sentence));
        CHECK_THROWS_WITH(world.set(kept, spring), ContainsSubstring("World::set: " + sentence));
        CHECK(world.hash() == before);
    };
    refused({a, b, -1.0 * N_per_m}, "stiffness is -1 N/m");
    refused({a, b, NAN * N_per_m}, "stiffness is nan N/m");
    refused({a, b, 1.0 * N_per_m, -2.0 * N_s_per_m}, "damping is -2 kg/s");
    refused({a, b, 1.0 * N_per_m, 0.0 * N_s_per_m, NAN * metre}, "rest length is nan m");
    refused({a, b, 1.0 * N_per_m, 0.0 * N_s_per_m, -1.0 * metre}, "rest length is -1 m");
    refused({a, a, 1.0 * N_per_m}, "its ends is one body");
    refused({metres(0, 0), metres(1, 0), 1.0 * N_per_m}, "its ends is two points");
    refused({.first = a, .stiffness = 1.0 * N_per_m}, "its second end is not given");
    refused({a, metres(INFINITY, 0), 1.0 * N_per_m}, "anchor is (inf, 0, 0) m");
    CHECK_THROWS_WITH(world.add(Spring{a, metres(0, 0, 5), 1.0 * N_per_m}), ContainsSubstring("two dimensions"));
    CHECK_THROWS_WITH(world.add(Spring{a, b, 1e300 * N_per_m}), ContainsSubstring("the world's scalar can hold it"));
    CHECK_THROWS_WITH(world.add(Spring{a, Handle{7, 0}, 1.0 * N_per_m}), ContainsSubstring("body 7"));
    CHECK_THROWS_AS(world.add(Spring{Handle{}, b, 1.0 * N_per_m}), std::out_of_range);
    CHECK_THROWS_WITH(world.add(Spring{a, b, 1.0 * N_per_m}, breaks_at(-3.0 * newton)),
                      ContainsSubstring("break force is -3 N"));
    CHECK_THROWS_WITH(world.add(Spring{a, b, 1.0 * N_per_m}, breaks_at(0)), ContainsSubstring("break strain is 0"));
    CHECK_THROWS_WITH(world.add(Spring{a, b, 1.0 * N_per_m, {}, 0.0 * metre}, breaks_at(0.5)),
                      ContainsSubstring("rest length 0 has no strain"));
    CHECK(world.hash() == before);
    World undamped{Verlet{}, Springs<Undamped>{}};
    const auto c = undamped.add(mass(1.0 * kilogram));
    CHECK_THROWS_WITH(undamped.add(Spring{c, metres(1, 0, 0), 1.0 * N_per_m, 1.0 * N_s_per_m}),
                      ContainsSubstring("damping is 1 kg/s; the springs of this world are Undamped"));
}

TEST_CASE("a copy of a world has the springs, takes the handles and continues to the bit", "[springs]") {
    World world{VelocityVerlet{}, Gravity{}, Springs<Breaking>{}, Ropes{}};
    const auto chain = hang_chain(world, 6, 0.1, 200, 0.1, 0.2);
    const auto rope = world.add(Rope{chain[5], metres(1, 0, 0), 50.0 * N_per_m});
    run(world, 50, 0.005);
    auto copy = world;
    CHECK(copy.hash() == world.hash());
    CHECK(copy.contains(rope));
    run(world, 50, 0.005);
    run(copy, 50, 0.005);
    CHECK(copy.hash() == world.hash());
    copy.remove(rope);
    CHECK_FALSE(copy.hash() == world.hash());
    CHECK(world.contains(rope));
    auto moved = std::move(copy);
    CHECK(moved.elements<Spring>().size() == 6);
    CHECK(copy.elements<Spring>().size() == 0); // NOLINT: moved from, a world is empty
    const auto again = copy.add(position(metres(0, 0, 0)), mass(1.0 * kilogram));
    copy.add(Spring{again, metres(0, 1, 0), 1.0 * N_per_m});
    copy.step(0.01 * second);
    CHECK(copy.status().ok());
}

TEST_CASE("the hash sees every number of a spring, and its ends", "[springs]") {
    auto hash_with = [](const Spring& spring, auto... limit) {
        World world{SemiImplicitEuler{}, Springs<Breaking>{}};
        world.add(position(metres(0, 0, 0)), mass(1.0 * kilogram));
        world.add(position(metres(1, 0, 0)), mass(1.0 * kilogram));
        world.add(position(metres(2, 0, 0)), mass(1.0 * kilogram));
        world.add(spring, limit...);
        return world.hash();
    };
    const Handle a{0, 0}, b{1, 0}, c{2, 0};
    const auto plain = hash_with({a, b, 1.0 * N_per_m, 1.0 * N_s_per_m, 1.0 * metre});
    CHECK(plain == hash_with({a, b, 1.0 * N_per_m, 1.0 * N_s_per_m, 1.0 * metre}));
    CHECK_FALSE(plain == hash_with({a, c, 1.0 * N_per_m, 1.0 * N_s_per_m, 1.0 * metre}));
    CHECK_FALSE(plain == hash_with({a, b, 2.0 * N_per_m, 1.0 * N_s_per_m, 1.0 * metre}));
    CHECK_FALSE(plain == hash_with({a, b, 1.0 * N_per_m, 2.0 * N_s_per_m, 1.0 * metre}));
    CHECK_FALSE(plain == hash_with({a, b, 1.0 * N_per_m, 1.0 * N_s_per_m, 2.0 * metre}));
    CHECK_FALSE(plain == hash_with({a, b, 1.0 * N_per_m, 1.0 * N_s_per_m, 1.0 * metre}, breaks_at(1.0 * newton)));
    CHECK_FALSE(hash_with({a, metres(0, 1, 0), 1.0 * N_per_m, {}, 1.0 * metre}) ==
                hash_with({a, metres(0, 2, 0), 1.0 * N_per_m, {}, 1.0 * metre}));
}
