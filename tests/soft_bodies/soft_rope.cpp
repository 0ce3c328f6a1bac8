// SPDX-License-Identifier: BSL-1.0
// Ropes of several bodies: what is built, that they hang by the chain's formula and never push, and what is refused.

#include <ansatz/soft_bodies/soft_rope.hpp>

#include "tests/soft_bodies/support.hpp"

using namespace soft_tests;

namespace {
SoftRope line(std::size_t bodies) {
    return {.from = metres(0.1, 0.2, 0),
            .to = metres(0.7, 0.9, 0),
            .bodies = bodies,
            .mass_per_length = 0.5 * kilogram_per_metre,
            .links = {300.0 * N_per_m, 0.3 * N_s_per_m}};
}
} // namespace

TEST_CASE("a rope is bodies and links from end to end, without tension, with the mass of its length", "[soft_bodies]") {
    World world{SemiImplicitEuler{}, Ropes{}, Space<float, 2>{}};
    for (const std::size_t n : {2, 3, 20}) {
        INFO(n << " bodies");
        auto copy = world;
        const SoftRopeParts parts = add_rope(copy, line(n));
        REQUIRE(parts.bodies.size() == n);
        REQUIRE(parts.links.size() == n - 1);
        CHECK(copy.size() == n);
        CHECK(copy.elements<Rope>().size() == n - 1);
        CHECK(copy.position(parts.bodies.front()) == scalar_cast<float>(metres(0.1, 0.2)));
        CHECK(copy.position(parts.bodies.back()) == scalar_cast<float>(metres(0.7, 0.9)));
        for (std::size_t i = 0; i + 1 < n; ++i) {
            const Rope link = copy.get(parts.links[i]);
            CHECK(link.first.body() == parts.bodies[i]);
            CHECK(link.second.body() == parts.bodies[i + 1]);
        }
        CHECK(mass_of_all(copy) == Approx(0.5 * std::hypot(0.6, 0.7)).epsilon(1e-6));
        CHECK(largest_tension<Ropes<>>(copy) == 0);
        const auto before = copy;
        run(copy, 200, 0.005);
        for (const Handle body : parts.bodies) CHECK(copy.position(body) == before.position(body));
    }
}

TEST_CASE("a hung rope is longer by what hangs below each link; pushed together it does nothing", "[soft_bodies]") {
    World world{SemiImplicitEuler{}, Gravity{}, Ropes{}, Drag{3.0 / second}};
    SoftRope rope = line(11);
    rope.from = metres(0, 0, 0);
    rope.to = metres(0, -1, 0);
    rope.pins = {0};
    const auto parts = add_rope(world, rope);
    run(world, 8000, 0.002);
    // The last body has half of the others' mass: m g N^2 / 2k.
    const double stretch = -world.position(parts.bodies[10]).value()[1] - 1;
    CHECK(std::abs(stretch - 0.05 * 9.81 * 100 / 600) <= 1e-6);

    World slack{SemiImplicitEuler{}, Ropes{}};
    rope.dragged = {10};
    const auto folded = add_rope(slack, rope);
    slack.set_velocity(folded.bodies[10], metres_per_second(0, 1, 0));
    run(slack, 30, 0.005); // up to the body above and past it, but not by a link
    for (std::size_t i = 1; i < 10; ++i) CHECK(norm(slack.velocity(folded.bodies[i])).value() == 0);
}

TEST_CASE("ropes that cannot be are refused, and the world is as it was", "[soft_bodies]") {
    World world{SemiImplicitEuler{}, Ropes{}};
    const auto before = world.hash();
    const auto said = [&](auto&& change) {
        SoftRope rope = line(5);
        change(rope);
        const auto sentence = refusal([&] { add_rope(world, rope); });
        CHECK(world.hash() == before);
        return sentence;
    };
    CHECK(said([](SoftRope& r) { r.bodies = 1; }) ==
          "add_rope: bodies is 1; a rope has at least 2, and 2^31 - 1 at most");
    CHECK(said([](SoftRope& r) { r.to = r.from; }) ==
          "add_rope: the distance of from and to is 0 m; it is finite and greater than zero");
    CHECK(said([](SoftRope& r) { r.mass_per_length = -1.0 * kilogram_per_metre; }) ==
          "add_rope: mass per length is -1 kg/m; it must be finite and greater than zero");
    CHECK(said([](SoftRope& r) { r.links.stiffness = -1.0 * N_per_m; }) ==
          "add_rope: links' stiffness is -1 N/m; it must be finite and not negative");
    CHECK(said([](SoftRope& r) { r.pins = {5}; }) == "add_rope: pins[0] is 5; there are 5 of them, from 0");
    CHECK(said([](SoftRope& r) { r.from = metres(0, std::numeric_limits<double>::infinity(), 0); }) ==
          "add_rope: from is (0, inf, 0) m; it must be finite");
}
