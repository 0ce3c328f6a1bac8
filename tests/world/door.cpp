// SPDX-License-Identifier: BSL-1.0
// The door: whatever is wrong is refused with a sentence that names it, its value, its unit and what would be right,
// and the world is left as it was.

#include <ansatz/world/add_facts.hpp>
#include <ansatz/world/door.hpp>

#include <ansatz/world/checked_value.hpp>

#include "tests/catch.hpp"
#include "tests/world/worlds.hpp"

#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

using namespace ansatz;
using namespace ansatz::test;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

// Both scalars, both dimensions; one integrator that keeps a velocity and the one that does not.
using Flat = World<Space<float, 2>, Verlet, Gravity, AppliedForces, Rest>;
using Solid = World<RungeKutta4, Gravity, AppliedForces, Keep<Heat, Home>>;

#define ANSATZ_DOOR_WORLDS Flat, Solid

/// A world of every kind of body, some steps old, with its handles.
template <class W> struct Scene {
    W world = [] {
        return []<class... P>(std::type_identity<World<P...>>) { return World<P...>(P{}...); }(std::type_identity<W>{});
    }();
    Handle body =
        world.add(position(vec<W>(metre, 1, 2, 3)), velocity(vec<W>(metre_per_second, 4, 5, 6)), mass(2.0 * kilogram));
    Handle ground = world.add(fixed);
    Handle platform = world.add(moving, velocity(vec<W>(metre_per_second, 1, 0)));

    Scene() {
        for (int i = 0; i < 3; ++i) world.step(1.0 / 60 * second);
    }

    /// Calls `f`, which must be refused with a sentence that begins as given and has all the parts, and change nothing.
    template <class F> void refuses(F&& f, const std::string& begin, const std::vector<std::string>& parts) {
        const W before = world;
        const std::string text = sentence<std::invalid_argument>(f);
        INFO(text);
        CHECK(text.substr(0, begin.size()) == begin);
        for (const auto& part : parts) {
            INFO("should contain: " << part);
            CHECK(text.find(part) != std::string::npos);
        }
        CHECK(world.hash() == before.hash());
        CHECK(world.size() == before.size());
        CHECK(world.handles() == before.handles());
        W after = world, twin = before;
        after.step(1.0 / 60 * second);
        twin.step(1.0 / 60 * second);
        CHECK(after.hash() == twin.hash()); // nothing was changed that only the next step would show
    }
};

/// Numbers that no quantity of a world may have, and how a sentence shows them.
template <class W> std::vector<std::pair<double, std::string>> not_numbers() {
    std::vector<std::pair<double, std::string>> all{{not_a_number, "nan"}, {infinity, "inf"}, {-infinity, "-inf"}};
    if (std::is_same_v<typename W::Scalar, float>) all.push_back({1e300, "1e+300"}); // finite, and not in this world
    return all;
}

} // namespace

TEMPLATE_TEST_CASE("add refuses a mass that is no mass, with its value and unit", "[world][door][I21]",
                   ANSATZ_DOOR_WORLDS) {
    Scene<TestType> scene;
    auto wrong = not_numbers<TestType>();
    wrong.insert(wrong.end(), {{0.0, "0 kg"}, {-0.0, "0 kg"}, {-3.0, "-3 kg"}, {5e-324, "kg"}});
    for (const auto& [value, shown] : wrong) {
        const auto m = value * kilogram;
        scene.refuses([&] { scene.world.add(mass(m)); }, "World::add: mass is ",
                      {shown, "kg; ", "finite and greater than 0 kg", "fixed"});
        scene.refuses([&] { scene.world.set_mass(scene.body, m); }, "World::set_mass: mass is ",
                      {shown, "kg; ", "greater than 0 kg"});
    }
}

TEMPLATE_TEST_CASE("a mass whose reciprocal the scalar cannot hold is refused, one that it can hold is taken",
                   "[world][door][I21]", ANSATZ_DOOR_WORLDS) {
    using Scalar = typename TestType::Scalar;
    Scene<TestType> scene;
    // 1/m must be finite and not zero: 1/m of the largest number is denormal in both scalars, 1/m of a denormal is
    // infinite.
    const double tiny = double(std::numeric_limits<Scalar>::min()), huge = double(std::numeric_limits<Scalar>::max());
    const auto light = scene.world.add(mass(tiny * 2 * kilogram)), heavy = scene.world.add(mass(huge / 8 * kilogram));
    CHECK(double(scene.world.mass(light).value()) == tiny * 2);
    CHECK(double(scene.world.inverse_mass(heavy).value()) > 0);
    scene.refuses([&] { scene.world.add(mass(tiny / 8 * kilogram)); }, "World::add: mass is ", {"kg"});
}

TEMPLATE_TEST_CASE("positions, velocities, impulses and forces that are not finite are refused, in every component",
                   "[world][door][I21]", ANSATZ_DOOR_WORLDS) {
    using W = TestType;
    Scene<W> scene;
    auto& world = scene.world;
    for (const auto& [value, shown] : not_numbers<W>())
        for (int component = 0; component < W::S::dimension; ++component) {
            double c[3] = {1, 2, 3};
            c[component] = value;
            const auto x = vec<W>(metre, c[0], c[1], c[2]);
            const auto v = vec<W>(metre_per_second, c[0], c[1], c[2]);
            const auto j = vec<W>(newton_second, c[0], c[1], c[2]);
            const auto f = vec<W>(newton, c[0], c[1], c[2]);
            const std::string finite = "every component is a finite number";
            const auto kilo = mass(1.0 * kilogram);
            scene.refuses([&] { world.add(position(x), kilo); }, "World::add: position is (", {shown, ") m; ", finite});
            scene.refuses([&] { world.add(velocity(v), kilo); }, "World::add: velocity is (",
                          {shown, ") m/s; ", finite});
            scene.refuses([&] { world.set_position(scene.body, x); }, "World::set_position: position is (",
                          {shown, ") m; ", finite});
            scene.refuses([&] { world.set_velocity(scene.body, v); }, "World::set_velocity: velocity is (",
                          {shown, ") m/s; ", finite});
            scene.refuses([&] { world.apply_impulse(scene.body, j); }, "World::apply_impulse: impulse is (",
                          {shown, ") ", "; ", finite});
            scene.refuses([&] { world.apply_force(scene.body, f); }, "World::apply_force: force is (",
                          {shown, ") N; ", finite});
        }
}

TEMPLATE_TEST_CASE("a time step that is negative, not a number or infinite is refused before anything moves",
                   "[world][door][I21]", ANSATZ_DOOR_WORLDS) {
    using W = TestType;
    Scene<W> scene;
    auto wrong = not_numbers<W>();
    wrong.insert(wrong.end(), {{-1.0 / 64, "-0.015625"}, {-5e-324, "e-324"}});
    for (const auto& [value, shown] : wrong) {
        const auto dt = value * second;
        scene.refuses([&] { scene.world.step(dt); }, "World::step: dt is ", {shown, " s; "});
    }
    // Too small for a float, and so a step of zero that the clock would count.
    if (std::is_same_v<typename W::Scalar, float>)
        scene.refuses([&] { scene.world.step(1e-60 * second); }, "World::step: dt is 1e-60 s; ",
                      {"that the world's scalar can hold"});
}

TEMPLATE_TEST_CASE("a sum of forces, or a velocity after an impulse, that is not finite is refused",
                   "[world][door][I21]", ANSATZ_DOOR_WORLDS) {
    using W = TestType;
    Scene<W> scene;
    const double huge = 0.9 * double(std::numeric_limits<typename W::Scalar>::max());
    scene.world.apply_force(scene.body, vec<W>(newton, huge, 0));
    scene.refuses([&] { scene.world.apply_force(scene.body, vec<W>(newton, huge, 0)); },
                  "World::apply_force: force is (", {") N; the sum of the forces applied is finite"});
    const auto light = scene.world.add(mass(0.001 * kilogram));
    scene.refuses([&] { scene.world.apply_impulse(light, vec<W>(newton_second, huge, 0)); },
                  "World::apply_impulse: impulse is (", {"; the velocity after it is finite"});
}

TEST_CASE("with and write refuse values that are not finite, with the column's own name and unit", "[world][door]") {
    Scene<Solid> scene;
    scene.refuses([&] { scene.world.add(mass(1.0 * kilogram), with<Heat>(not_a_number * joule)); },
                  "World::add: heat is nan J; ", {"finite"});
    scene.refuses([&] { scene.world.write<Heat>(scene.body, infinity * joule); }, "World::write: heat is inf J; ",
                  {"finite"});
    scene.refuses([&] { scene.world.write<Home>(scene.body, metres(0, -infinity, 0)); },
                  "World::write: home is (0, -inf, 0) m; ", {"finite"});
    scene.world.write<Heat>(scene.body, 3.0 * joule);
    scene.world.write<Home>(scene.body, metres(1, 2, 3));
    CHECK(scene.world.read<Heat>(scene.body) == 3.0 * joule);
    CHECK(scene.world.read<Home>(scene.body) == metres(1, 2, 3));
}

TEMPLATE_TEST_CASE("what has no velocity or no mass is not given one", "[world][door]", ANSATZ_DOOR_WORLDS) {
    using W = TestType;
    Scene<W> scene;
    auto& world = scene.world;
    scene.refuses([&] { world.set_velocity(scene.ground, vec<W>(metre_per_second, 1, 0)); },
                  "World::set_velocity: the body is fixed; ", {"moving"});
    for (const auto& [h, kind] : {std::pair(scene.ground, "fixed"), std::pair(scene.platform, "moving")}) {
        const std::string begin = std::string("World::set_mass: the body is ") + kind + "; ";
        scene.refuses([&, body = h] { world.set_mass(body, 1.0 * kilogram); }, begin, {"infinite"});
        // An impulse or a force on it is no mistake: a body of infinite mass does not notice.
        const auto before = world.hash();
        world.apply_impulse(h, vec<W>(newton_second, 1, 1));
        world.apply_force(h, vec<W>(newton, 1, 1));
        CHECK(world.hash() == before);
    }
}

TEMPLATE_TEST_CASE("a policy that is not acceptable is refused by set, and the old one goes on acting", "[world][door]",
                   ANSATZ_DOOR_WORLDS) {
    using W = TestType;
    Scene<W> scene;
    auto& world = scene.world;
    scene.refuses([&] { world.set(Gravity{metres_per_second_squared(0, not_a_number, 0)}); },
                  "Gravity: acceleration is (0, nan, 0) m", {"it must be finite"});
    if constexpr (W::S::dimension == 2)
        scene.refuses([&] { world.set(Gravity{metres_per_second_squared(0, 0, 1)}); },
                      "World: Gravity::acceleration is (0, 0, 1) m", {"two dimensions", "third component must be 0"});
    CHECK(world.template get<Gravity>().acceleration == metres_per_second_squared(0, -9.81, 0));
    CHECK(double(world.acceleration(scene.body).value()[1]) == Catch::Approx(-9.81));
}

TEST_CASE("construction refuses the parameters of policies with one sentence each", "[world][door]") {
    auto refused = [](auto&& make) { return sentence<std::invalid_argument>(make); };
    CHECK(refused([] { World world{SemiImplicitEuler{}, Drag{-0.5 / second}}; }).find("Drag: rate is -0.5 ") == 0);
    CHECK(refused([] {
              World world{SemiImplicitEuler{}, Drag{not_a_number / second}};
          }).find("Drag: rate is nan ") == 0);
    CHECK(refused([] { World world{SemiImplicitEuler{}, FrameDrag{1.5}}; }).find("FrameDrag: factor is 1.5; ") == 0);
    CHECK(refused([] {
              World world{RungeKutta4{}, QuadraticDrag{-1.0 * kilogram_per_metre}};
          }).find("QuadraticDrag: coefficient is -1 kg/m; ") == 0);
    CHECK(refused([] {
              World world{SemiImplicitEuler{}, StopBelow{-1.0 * metre_per_second}};
          }).find("StopBelow: threshold is -1 m/s; ") == 0);
}
