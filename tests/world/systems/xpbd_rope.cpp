// SPDX-License-Identifier: BSL-1.0
// What a rope of a user's own does, of xpbd_rope.hpp.

#include "tests/world/systems/xpbd_rope.hpp"

#include <ansatz/world/save.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <sstream>
#include <vector>

using namespace examples;

namespace {

template <class Scalar> auto rope_of(int links) {
    World world{Space<Scalar, 3>{}, SemiImplicitEuler{}, Gravity{}, Keep<InverseMass>{}, XpbdRope{}};
    auto last = world.add(position(metres(0, 0, 0)), fixed);
    for (int i = 1; i <= links; ++i) {
        const auto next = world.add(position(metres(0.1 * i, 0, 0)), mass(0.1 * kilogram));
        world.add(Link{last, next, 0.1 * metre});
        last = next;
    }
    return std::pair(world, last);
}

} // namespace

TEMPLATE_TEST_CASE("A rope of a user's own swings in its own substeps and keeps its length", "[systems]", double,
                   float) {
    auto [world, end] = rope_of<TestType>(10);
    for (int i = 0; i < 300; ++i) world.step(1.0 / 60 * second);
    CHECK(world.status().ok());
    double longest = 0;
    const auto all = world.handles();
    for (std::size_t i = 1; i < all.size(); ++i)
        longest = std::max(longest, double(norm(world.position(all[i]) - world.position(all[i - 1])).value()));
    CHECK(longest < 0.101);
    CHECK(double(world.position(end).value()[1]) < -0.3); // it has fallen
}
TEST_CASE("A rope whose link goes with a body is two ropes", "[systems]") {
    auto [world, end] = rope_of<double>(10);
    for (int i = 0; i < 30; ++i) world.step(1.0 / 60 * second);
    world.remove(world.handles()[5]);
    CHECK(world.elements<Link>().size() == 8);
    for (int i = 0; i < 60; ++i) world.step(1.0 / 60 * second);
    CHECK(world.status().ok());
    CHECK(world.position(end).value()[1] < -4); // it falls
}
TEST_CASE("It is a part of the world's value: copied, hashed, saved and loaded", "[systems]") {
    auto [world, end] = rope_of<double>(6);
    for (int i = 0; i < 20; ++i) world.step(1.0 / 60 * second);
    auto copy = world;
    std::stringstream file;
    save(world, file);
    auto [loaded, ignored] = rope_of<double>(2);
    CHECK(loaded.hash() != world.hash());
    load(loaded, file);
    CHECK(loaded.hash() == world.hash());
    for (int i = 0; i < 20; ++i) {
        world.step(1.0 / 60 * second);
        copy.step(1.0 / 60 * second);
        loaded.step(1.0 / 60 * second);
    }
    CHECK(copy.hash() == world.hash());
    CHECK(loaded.hash() == world.hash());
    CHECK(loaded.position(end) == world.position(end));
}
