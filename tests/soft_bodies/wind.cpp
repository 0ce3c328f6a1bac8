// SPDX-License-Identifier: BSL-1.0
// Wind: forces on a triangle by their closed forms, what they take, a plate that falls as tanh, and a sheet after a
// storm.

#include <ansatz/soft_bodies/wind.hpp>

#include <ansatz/motion/energy.hpp>
#include <ansatz/motion/integrators/conjugate_gradient.hpp>
#include <ansatz/soft_bodies/xpbd.hpp>
#include <ansatz/springs/stable_step.hpp>
#include <ansatz/world/save.hpp>

#include "tests/soft_bodies/support.hpp"

#include <random>
#include <sstream>

using namespace soft_tests;
using Catch::Matchers::ContainsSubstring;

namespace {

using Vec = Vector<double, 3>;

template <class Scalar = double, class... Solver> auto airy(const Solver&... solver) {
    return World{
        Space<Scalar, 3>{}, SemiImplicitEuler{}, Gravity{metres_per_second_squared(0, 0, 0)}, Springs<>{}, Wind{},
        solver...};
}
auto metres_of(const Vec& x) { return VectorQuantity<unit::Length>::from_value(x); }
auto velocity_of(const Vec& v) { return VectorQuantity<unit::Velocity>::from_value(v); }

/// A triangle of area 0.06 m^2 in the plane of x and y, turned; each corner of 0.1 kg.
template <class World_>
std::vector<Handle> add_sail(World_& world, const Eigen::Matrix3d& turned, double drag, double lift,
                             bool other_way = false) {
    std::vector<Handle> all;
    for (const Vec& x : {Vec(0.1, 0.1, 0), Vec(0.5, 0.1, 0), Vec(0.2, 0.4, 0)})
        all.push_back(world.add(position(metres_of(turned * x)), mass(0.1 * kilogram)));
    if (other_way) std::swap(all[0], all[1]);
    world.add(Sail{{all[0], all[1], all[2]}, drag, lift});
    return all;
}
/// The force on all of it, by what one short step changes.
Vec force_on(auto world, const std::vector<Handle>& all) {
    Vec before = Vec::Zero(), after = Vec::Zero();
    for (const auto& body : all) before += 0.1 * world.velocity(body).value();
    std::vector<Vec> were;
    for (const auto& body : all) were.push_back(world.velocity(body).value());
    world.step(1e-3 * second);
    for (const auto& body : all) after += 0.1 * world.velocity(body).value();
    for (std::size_t i = 0; i < all.size(); ++i) // each has a third
        CHECK((0.3 * (world.velocity(all[i]).value() - were[i]) - (after - before)).norm() < 1e-12);
    return (after - before) / 1e-3;
}
Eigen::Matrix3d turned(double about_x) { return Eigen::AngleAxisd(about_x, Vec::UnitX()).toRotationMatrix(); }

} // namespace

TEST_CASE("A plate in the wind feels what the closed forms say, from either side", "[soft_bodies][wind]") {
    const double w = 5, area = 0.06, density = 1.3, head = 0.5 * density * area * w * w;
    const bool other_way = GENERATE(false, true);
    const auto blown = [&](double about_x, double drag, double lift) {
        auto world = airy();
        world.set(Wind{metres_per_second(0, 0, w), density * kilogram_per_cubic_metre});
        const auto all = add_sail(world, turned(about_x), drag, lift, other_way); // before force_on copies the world
        return force_on(world, all);
    };
    const double right = 1.5707963267948966;
    CHECK((blown(0, 1.2, 0.7) - Vec(0, 0, 1.2 * head)).norm() < 1e-12);
    CHECK(blown(right, 1.2, 0.7).norm() < 1e-12);
    for (const double angle : {0.3, 0.7853981633974483, 1.2, -0.5, 2.5}) {
        const double cosine = std::abs(std::cos(angle));
        const Vec normal = turned(angle) * Vec(0, 0, std::cos(angle) > 0 ? 1 : -1);
        CAPTURE(angle);
        CHECK((blown(angle, 1.2, 0) - Vec(0, 0, 1.2 * head * cosine)).norm() < 1e-12);
        const Vec lift = blown(angle, 0, 0.7);
        CHECK((lift - 0.7 * head * cosine * (normal - cosine * Vec(0, 0, 1))).norm() < 1e-12);
        CHECK(std::abs(lift[2]) < 1e-12); // across the wind, so that the air loses nothing by it
        CHECK(lift.norm() == Approx(0.35 * head * std::abs(std::sin(2 * angle))).epsilon(1e-9));
    }
}

TEST_CASE("What counts is how it moves in the air", "[soft_bodies][wind]") {
    std::mt19937 random(8);
    std::uniform_real_distribution<double> number(-4, 4);
    for (int n = 0; n < 20; ++n) {
        const Vec wind(number(random), number(random), number(random)), with(number(random), number(random), 0.3);
        const auto turn = turned(number(random));
        auto still = airy(), carried = airy();
        still.set(Wind{.velocity = velocity_of(wind)});
        carried.set(Wind{.velocity = velocity_of(wind + with)});
        const auto a = add_sail(still, turn, 1, 0.6), b = add_sail(carried, turn, 1, 0.6);
        for (const auto& body : b) carried.set_velocity(body, velocity_of(with));
        const Vec force = force_on(still, a);
        CHECK((force - force_on(carried, b)).norm() < 1e-10);
        CHECK(force.dot(wind) >= 0); // it goes along
        auto gone = airy();
        gone.set(Wind{.velocity = velocity_of(with)});
        const auto c = add_sail(gone, turn, 1, 0.6);
        for (const auto& body : c) gone.set_velocity(body, velocity_of(with));
        CHECK(force_on(gone, c).norm() < 1e-12); // what goes with the wind feels none
    }
}

TEST_CASE("A plate falls face-on as a tanh of the time", "[soft_bodies][wind]") {
    // m v' = m g - 1/2 rho c A v^2, so v = v_e tanh(g t / v_e).
    World world{RungeKutta4{}, Gravity{metres_per_second_squared(0, 0, -9.81)}, Wind{}};
    const auto all = add_sail(world, turned(0), 1.1, 0.5);
    const double end = std::sqrt(2 * 0.3 * 9.81 / (1.2 * 1.1 * 0.06));
    run(world, 400, 1e-2);
    for (const auto& body : all) {
        const Vec v = world.velocity(body).value();
        CHECK(v[2] == Approx(-end * std::tanh(9.81 * 4 / end)).epsilon(1e-9));
        CHECK(v.head<2>().norm() < 1e-12);
    }
    World implicit{Space<double, 3>{}, ImplicitEuler{}, Gravity{metres_per_second_squared(0, 0, -9.81)}, Springs<>{},
                   Wind{}};
    const auto there = add_sail(implicit, turned(0), 1.1, 0.5);
    run(implicit, 200, 0.5);
    CHECK(implicit.status().ok());
    CHECK(implicit.velocity(there[1]).value()[2] == Approx(-end).epsilon(1e-9));
}

TEST_CASE("Still air only takes energy, whatever the sheet does", "[soft_bodies][wind]") {
    auto world = airy();
    auto cloth = woven(6, 6);
    cloth.structural = cloth.shear = cloth.bend = {};
    cloth.drag = 1;
    cloth.lift = 0.8;
    const auto parts = add_cloth(world, cloth);
    CHECK(parts.sails.size() == 50);
    std::mt19937 random(8);
    std::uniform_real_distribution<double> number(-3, 3);
    for (const auto& body : parts.bodies)
        world.set_velocity(body, metres_per_second(number(random), number(random), number(random)));
    for (int i = 0; i < 300; ++i) {
        const double before = kinetic_energy(world).value();
        world.step(1e-3 * second);
        CHECK(kinetic_energy(world).value() <= before);
    }
}

TEST_CASE("Its derivative is that of the drag from the front, and bounds the step", "[soft_bodies][wind]") {
    World world{Space<double, 3>{}, ImplicitEuler{}, Gravity{}, Springs<>{}, Wind{metres_per_second(0, 0, 6)}};
    add_sail(world, turned(0), 1.2, 0);
    const auto view = world.view<Wind>();
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    Wind::In<Space<>>(world.get<Wind>())
        .jacobian(view, world.context().restricted<false>(),
                  [&](std::size_t, std::size_t b, const Eigen::Matrix3d& x, const Eigen::Matrix3d& v) {
                      CHECK(b == 3);
                      CHECK(x.isZero(0));
                      sum += v;
                  });
    const double slope = 0.5 * 1.2 * 1.2 * 0.06 * 6; // dF/dv of 1/2 rho c A u w: twice along, once across
    CHECK((sum + slope * Vec(1, 1, 2).asDiagonal().toDenseMatrix()).norm() < 1e-12);
    CHECK(stiffness_of(world).damping.value() == Approx(2 * slope / 3 / 0.1).epsilon(1e-12));
}

TEMPLATE_TEST_CASE("hard case K10: a storm, and then none: finite, and the sheet hangs again as it hung",
                   "[soft_bodies][wind][K10]", double, float) {
    // A storm stretches such a sheet to several times its size and lets it go: an implicit step, or none that is short.
    World world{Space<TestType, 3>{}, ImplicitEuler{.tolerance = 0.01, .most_iterations = 10},
                Gravity{metres_per_second_squared(0, -9.81, 0)}, Springs<>{}, Wind{}};
    const std::size_t n = 6;
    Cloth cloth{.mesh = sheet(n, n),
                .mass_per_area = 0.15 * kg_per_m2,
                .structural = {200.0 * N_per_m, 0.15 * N_s_per_m},
                .lumping = Lumping::equal,
                .drag = 1.2,
                .lift = 0.6};
    for (std::size_t i = 0; i < n; ++i) cloth.pins.push_back(std::uint32_t(n * (n - 1) + i));
    const auto parts = add_cloth(world, cloth);
    const double m = 0.15 * 0.25 / 36, hangs = m * 9.81 * 5 * 6 / 2 / 200; // of N links and equal masses
    run(world, 60, 1.0 / 60);
    world.set(Wind{.velocity = metres_per_second(0, 0, 100)});
    run(world, 60, 1.0 / 60);
    CHECK(!world.status().lost);
    double farthest = 0;
    for (const auto& body : parts.bodies) {
        REQUIRE(is_finite(world.position(body)));
        farthest = std::max(farthest, double(world.position(body).value()[2]));
    }
    CHECK(farthest > 0.3); // it was blown away
    world.set(Wind{});
    run(world, 900, 1.0 / 60);
    for (std::size_t i = 0; i < n; ++i) {
        double longer = -0.5; // by as much as a hanging chain of its springs, although it still swings a little
        for (std::size_t j = 0; j + 1 < n; ++j)
            longer += double(
                norm(world.position(parts.bodies[i + n * j]) - world.position(parts.bodies[i + n * j + n])).value());
        CHECK(longer == Approx(hangs).epsilon(0.01));
        CHECK(std::abs(double(world.position(parts.bodies[i]).value()[2])) < 0.1);
    }
}

TEST_CASE("A triangle without an area feels nothing", "[soft_bodies][wind]") {
    auto world = airy<float>();
    world.set(Wind{.velocity = metres_per_second(1, 2, 100)});
    std::vector<Handle> all;
    for (int i = 0; i < 3; ++i) all.push_back(world.add(position(metres(float(i), 0.0f, 0.0f)), mass(0.1 * kilogram)));
    world.add(Sail{{all[0], all[1], all[2]}, 1, 1});
    run(world, 3, 0.01);
    for (const auto& body : all) CHECK(world.velocity(body).value().isZero(0));
}

TEST_CASE("Sails are copied, hashed, saved and loaded beside a solver, and gone with any of their corners",
          "[soft_bodies][wind]") {
    auto world = airy<double>(Xpbd{5, 1});
    world.set(Wind{metres_per_second(3, 1, 4), 1.1 * kilogram_per_cubic_metre});
    auto cloth = woven(5, 5);
    cloth.drag = 1.2;
    cloth.lift = 0.5;
    cloth.pins = {0, 20};
    const auto parts = add_cloth(world, cloth);
    run(world, 20, 1.0 / 60);
    world.remove(parts.bodies[12]); // a corner of six
    CHECK(world.elements<Sail>().size() == 26);
    auto copy = world;
    std::stringstream file;
    save(world, file);
    auto loaded = airy<double>(Xpbd{});
    load(loaded, file);
    CHECK(loaded.get<Wind>().velocity.value() == Vec(3, 1, 4));
    for (auto* each : {&world, &copy, &loaded}) run(*each, 30, 1.0 / 60);
    CHECK(copy.hash() == world.hash());
    CHECK(loaded.hash() == world.hash());
    const auto is = world.get(parts.sails[0]);
    CHECK((is.drag == 1.2 && is.lift == 0.5 && is.corners[1] == parts.bodies[1]));
}

TEST_CASE("Bad air and bad sails are refused", "[soft_bodies][wind]") {
    auto world = airy();
    const auto all = add_sail(world, turned(0), 1, 0);
    const auto hash = world.hash();
    CHECK(refusal([&] { world.set(Wind{.density = -1.0 * kilogram_per_cubic_metre}); }) ==
          "Wind: density is -1 kg/m^3; it must be finite and not negative");
    CHECK_THAT(refusal([&] { world.set(Wind{.velocity = metres_per_second(0, NAN, 0)}); }),
               ContainsSubstring("Wind: velocity is"));
    CHECK_THAT(refusal([&] {
                   world.add(Sail{{all[0], all[1], all[2]}, -0.5, 0});
               }),
               ContainsSubstring("drag is -0.5") && ContainsSubstring("not negative"));
    CHECK_THAT(refusal([&] {
                   world.add(Sail{{all[0], all[1], all[2]}, 1, INFINITY});
               }),
               ContainsSubstring("lift is inf"));
    CHECK_THAT(refusal([&] { world.add(Sail{{all[0], all[1], all[0]}, 1, 0}); }), ContainsSubstring("three different"));
    auto cloth = woven(3, 3);
    cloth.lift = -1;
    CHECK_THAT(refusal([&] { add_cloth(world, cloth); }), ContainsSubstring("add_cloth: lift is -1"));
    cloth.lift = 1;
    World without{SemiImplicitEuler{}, Springs<>{}};
    CHECK_THAT(refusal([&] { add_cloth(without, cloth); }), ContainsSubstring("lift is 1; this world has no air"));
    CHECK(world.hash() == hash);
    CHECK(without.size() == 0);
}
