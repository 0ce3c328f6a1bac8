// SPDX-License-Identifier: BSL-1.0
// Enclosures: volumes against closed forms, the law of a filling, what is kept of them, and what is refused.
// Runs long with the sanitizers.

#include "tests/soft_bodies/fillings.hpp"

#include <sstream>

using namespace soft_tests;
using Catch::Matchers::ContainsSubstring;

TEST_CASE("A box and an octahedron enclose what the closed forms say, wherever they are", "[soft_bodies][pressure]") {
    const auto far = GENERATE(metres(0, 0, 0), metres(3, -4, 5), metres(1000, 2000, -500));
    auto world = free_world();
    const auto add = [&](const TriangleMesh& mesh) {
        const auto there = mesh.moved(far);
        return world.add(Enclosure::of(add_bodies(world, there), there, gas));
    };
    // Powers of two, so that no place is rounded when it is moved.
    const auto box = add(box_mesh(metres(2, 0.5, 4), 4, 2, 8));
    const auto octahedron = add(ball_mesh(0.75 * metre, 0));
    const auto apart = add(ball_mesh(0.5 * metre, 3));
    CHECK(enclosed_volume(world, box).value() == Approx(4).epsilon(1e-12));
    CHECK(enclosed_volume(world, octahedron).value() == Approx(4.0 / 3 * 0.75 * 0.75 * 0.75).epsilon(1e-12));
    CHECK(enclosed_volume(world, apart).value() == Approx(ball_mesh(0.5 * metre, 3).volume().value()).epsilon(1e-12));
}

TEST_CASE("The law of a filling: a gas, a stiffness, and its tangent where it is pressed to nothing",
          "[soft_bodies][pressure]") {
    const detail::FillingLaw<double> law{300, 120, 700, 0.2};
    CHECK(law.excess(0.2) == Approx(180));
    CHECK(law.excess(0.1) == Approx(600 - 120 + 350));
    CHECK(law.energy(0.2) == 0);
    for (const double v : {-0.1, 0.0, 0.001, 0.0019, 0.0021, 0.05, 0.2, 1.7}) {
        const double d = 1e-7;
        CAPTURE(v);
        CHECK(law.excess(v) == Approx(-(law.energy(v + d) - law.energy(v - d)) / (2 * d)).epsilon(1e-6));
        CHECK(law.slope(v) == Approx(-(law.excess(v + d) - law.excess(v - d)) / (2 * d)).epsilon(1e-6));
        CHECK(law.slope(v) > 0);
    }
}

TEST_CASE("An enclosure is copied, hashed, saved and loaded, and gone with any of its bodies",
          "[soft_bodies][pressure]") {
    auto world = solved<double>(Xpbd{3, 2});
    const auto first = add_balloon(world, gas, 100, 1), second_ = add_balloon(world, both, 80, 1, 0.25);
    world.set_velocity(world.handles()[2], metres_per_second(1, 2, 3));
    run(world, 10, 1.0 / 60);
    world.remove(world.handles()[1]);
    CHECK(world.elements<Enclosure>().size() == 1);
    CHECK_THROWS_AS(enclosed_volume(world, first), std::out_of_range);
    auto copy = world;
    std::stringstream file;
    save(world, file);
    auto loaded = solved<double>(Xpbd{3, 2});
    load(loaded, file);
    for (auto* each : {&world, &copy, &loaded}) run(*each, 30, 1.0 / 60);
    CHECK(copy.hash() == world.hash());
    CHECK(loaded.hash() == world.hash());
    CHECK(enclosed_volume(loaded, second_) == enclosed_volume(world, second_));
    const auto is = world.get(second_);
    CHECK(is.filling.inside.value() == 300);
    CHECK(is.filling.damping.value() == 5);
    CHECK(is.triangles.size() == 8);
    CHECK(is.volume->value() == Approx(4.0 / 3 / 64).epsilon(1e-12));
    auto other = is;
    other.filling.inside = 301.0 * pascal;
    const auto before = world.hash();
    world.set(second_, other);
    CHECK(world.hash() != before);
    world.set(second_, is);
    CHECK(world.hash() == before);
}

TEST_CASE("A ball with a filling has no middle, the mass of the polyhedron, and bulges to the balance of its virial",
          "[soft_bodies][pressure]") {
    auto world = solved<double>();
    SoftBall ball{.centre = metres(1, 2, 3),
                  .radius = 0.3 * metre,
                  .density = 20.0 * kilogram_per_cubic_metre,
                  .divisions = 2,
                  .structural = {300.0 * N_per_m, 2.0 * N_s_per_m},
                  .filling = gas};
    const auto parts = add_soft_ball(world, ball);
    const auto mesh = ball_mesh(0.3 * metre, 2, metres(1, 2, 3));
    CHECK(parts.bodies.size() == 66);
    CHECK(world.size() == 66);
    CHECK(parts.spokes.empty());
    CHECK(mass_of_all(world) == Approx(20 * mesh.volume().value()).epsilon(1e-12));
    CHECK(excess_pressure(world, parts.enclosure).value() == Approx(200));
    run(world, 3000, 1.0 / 600);
    // At rest what the skin pulls, by how long it is, is three times what the filling presses, by how much it is.
    double pull = 0;
    Springs<>::In<Space<>>(Springs<>{}).tensions(world.view<Springs<>>(), [&](std::uint32_t id, const auto& t, auto) {
        const auto& link = world.view<Springs<>>().state().link(id);
        const auto view = world.view<Springs<>>();
        pull += t.value() *
                norm(view.get<Position>(view.slot_of_id(link.b)) - view.get<Position>(view.slot_of_id(link.a))).value();
    });
    const double press =
        excess_pressure(world, parts.enclosure).value() * enclosed_volume(world, parts.enclosure).value();
    CHECK(press > 10);
    CHECK(pull == Approx(3 * press).epsilon(1e-9));

    ball.spokes = {80.0 * N_per_m, 0.5 * N_s_per_m};
    CHECK(add_soft_ball(world, ball).bodies.size() == 67);
    const auto before = world.hash();
    ball.filling->inside = -1.0 * pascal;
    CHECK(refusal([&] { add_soft_ball(world, ball); }) ==
          "add_soft_ball: inside is -1 Pa; it must be finite and not negative");
    CHECK(world.hash() == before);
    ball.filling = gas;
    World without{SemiImplicitEuler{}, Springs<>{}};
    CHECK_THAT(refusal([&] { add_soft_ball(without, ball); }), ContainsSubstring("add Pressure{}"));
    CHECK(without.size() == 0);
}

TEST_CASE("What encloses nothing is refused, and says where", "[soft_bodies][pressure]") {
    auto world = solved<double>(Xpbd{});
    const auto mesh = ball_mesh(0.5 * metre, 0);
    const auto all = add_bodies(world, mesh);
    const auto good = Enclosure::of(all, mesh, gas);
    const auto before = world.hash();
    const auto says = [&](auto&& change) {
        auto bad = good;
        change(bad);
        return refusal([&] { world.add(bad); });
    };
    CHECK_THAT(says([](auto& e) { e.triangles.pop_back(); }),
               ContainsSubstring("the surface is open") && ContainsSubstring("a side of one triangle"));
    CHECK_THAT(says([](auto& e) { e.triangles[2][1] = 6; }),
               ContainsSubstring("triangle 2") && ContainsSubstring("vertex 6 does not exist"));
    CHECK_THAT(says([](auto& e) { e.triangles.push_back(e.triangles[1]); }), ContainsSubstring("triangle 8"));
    CHECK_THAT(says([](auto& e) { std::swap(e.triangles[0][0], e.triangles[0][1]); }),
               ContainsSubstring("there twice"));
    CHECK_THAT(says([](auto& e) {
                   for (auto& t : e.triangles) std::swap(t[0], t[1]);
               }),
               ContainsSubstring("enclosed volume") && ContainsSubstring("m^3") && ContainsSubstring("outside"));
    CHECK_THAT(says([](auto& e) { e.bodies[1] = e.bodies[0]; }), ContainsSubstring("of body 0 is 2"));
    CHECK_THAT(says([](auto& e) { e.filling = {}; }), ContainsSubstring("inside is 0 Pa"));
    CHECK_THAT(says([](auto& e) { e.filling.stiffness = -1.0 * pascal; }),
               ContainsSubstring("stiffness is -1 Pa") && ContainsSubstring("not negative"));
    CHECK_THAT(says([](auto& e) { e.filling.damping = NAN * pascal_second; }), ContainsSubstring("damping is"));
    CHECK_THAT(says([](auto& e) { e.volume = 0.0 * cubic_metre; }), ContainsSubstring("volume is 0 m^3"));
    CHECK_THAT(says([](auto& e) { e.volume = 1e-308 * cubic_metre; }),
               ContainsSubstring("volume is 1e-308 m^3") && ContainsSubstring("than the world's scalar can hold"));
    CHECK_THAT(says([](auto& e) {
                   e.volume = 1e-300 * cubic_metre;
                   e.filling = {.stiffness = 1.0 * pascal, .damping = 1e9 * pascal_second};
               }),
               ContainsSubstring("volume is 1e-300 m^3") && ContainsSubstring("than the world's scalar can hold"));
    CHECK_THAT(says([](auto& e) { e.filling = {.inside = 1e-310 * pascal, .outside = 1e5 * pascal}; }),
               ContainsSubstring("inside is 1e-310 Pa") && ContainsSubstring("so thin a gas"));
    CHECK_THROWS_AS(world.add([&] {
        auto bad = good;
        bad.bodies[0].generation += 1;
        return bad;
    }()),
                    std::out_of_range);
    CHECK(world.hash() == before);
    CHECK(world.elements<Enclosure>().size() == 0);
}

TEST_CASE("A ball that is too small for the scalar of its world, where it is, leaves the world as it was",
          "[soft_bodies][pressure]") {
    auto world = solved<float>(Xpbd{});
    const auto before = world.hash();
    const SoftBall ball{.centre = metres(1e6, 0, 0), // a float has steps of 6 cm there
                        .radius = 0.02 * metre,
                        .density = 40.0 * kilogram_per_cubic_metre,
                        .divisions = 0,
                        .structural = {10.0 * N_per_m},
                        .filling = gas};
    CHECK(refusal([&] { add_soft_ball(world, ball); }) != "");
    CHECK(world.size() == 0);
    CHECK(world.hash() == before);
}

TEST_CASE("A file with an enclosure that is none is refused", "[soft_bodies][pressure]") {
    auto world = solved<double>(Xpbd{});
    add_balloon(world, gas, 100, 1);
    std::stringstream file;
    save(world, file);
    const auto text = file.str();
    const auto with = [&](const std::string& from, const std::string& to) {
        auto changed = text;
        const auto at = changed.find(from, changed.find("\"Pressure\""));
        REQUIRE(at != std::string::npos);
        changed.replace(at, from.size(), to);
        std::stringstream in(changed);
        auto loaded = solved<double>(Xpbd{});
        return refusal([&] { load(loaded, in); });
    };
    CHECK_THAT(with("\"outside\":", "\"outside\": -1, \"was\":"), !ContainsSubstring("nothing"));
    CHECK_THAT(with("\"corners\":", "\"corners\": [0, 1, 2], \"was\":"), ContainsSubstring("at least 4"));
}
