// SPDX-License-Identifier: BSL-1.0
// StrainLimit: two bodies by closed form, what it keeps and what it takes, and row K5.
// Runs long with the sanitizers.

#include <ansatz/soft_bodies/strain_limit.hpp>

#include <ansatz/motion/energy.hpp>
#include <ansatz/soft_bodies/xpbd.hpp>
#include <ansatz/world/save.hpp>

#include "tests/soft_bodies/support.hpp"

#include <random>
#include <sstream>

using namespace soft_tests;
using Catch::Matchers::ContainsSubstring;

namespace {

template <class Scalar = double, class... P> auto limited(const P&... policies) {
    return World{Space<Scalar, 3>{}, SemiImplicitEuler{}, Gravity{}, Springs<>{}, policies...};
}
/// K5: 20 x 20 vertices, hung by two corners; its springs would be stretched by much.
Cloth hung(std::size_t n = 20) {
    return {.mesh = TriangleMesh::grid(n, n, metres(1, 0, 0), metres(0, -1, 0)),
            .mass_per_area = 0.3 * kg_per_m2,
            .structural = {20.0 * N_per_m, 0.02 * N_s_per_m},
            .shear = {20.0 * N_per_m, 0.02 * N_s_per_m},
            .pins = {0, std::uint32_t(n) - 1}};
}
/// Bodies here and there, each on springs to three others, some of them stretched by up to a half.
template <class World_> std::vector<Handle> add_net(World_& world, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> number(-1, 1);
    std::vector<Handle> all;
    for (int i = 0; i < 30; ++i)
        all.push_back(world.add(position(metres(number(random), number(random), number(random))),
                                velocity(metres_per_second(number(random), number(random), number(random))),
                                mass((1.2 + number(random)) * kilogram)));
    for (std::size_t i = 0; i < all.size(); ++i)
        for (const std::size_t by : {1, 7, 11}) {
            const auto other = all[(i + by) % all.size()];
            const auto apart = norm(world.position(all[i]) - world.position(other));
            world.add(Spring{all[i], other, 0.0 * N_per_m, 0.0 * N_s_per_m, (0.9 + 0.2 * number(random)) * apart});
        }
    return all;
}

} // namespace

TEST_CASE(
    "hard case K5: a sheet that hangs by two corners is stretched by no more than a tenth, and without a limit by much",
    "[soft_bodies][strain_limit][K5]") {
    const auto worst = [](auto world) {
        const auto parts = add_cloth(world, hung());
        const auto pin = world.position(parts.bodies[0]);
        double most = 0;
        for (int i = 0; i < 500; ++i) {
            world.step(1e-3 * second);
            most = std::max(most, double(largest_strain(world)));
        }
        CHECK(world.position(parts.bodies[0]) == pin);
        CHECK(world.status().ok());
        return most;
    };
    CHECK(worst(limited()) > 1); // reported
    CHECK(worst(limited(StrainLimit<>{.most = 0.09, .passes = 100})) <= 0.1);
}

TEMPLATE_TEST_CASE("Two bodies come to the limit by their masses, and separate no further",
                   "[soft_bodies][strain_limit]", double, float) {
    auto world = limited<TestType>(StrainLimit<>{.most = 0.25});
    world.set(Gravity{metres_per_second_squared(0, 0, 0)});
    const auto a =
        world.add(position(metres(1.0, 2.0, 3.0)), mass(1.0 * kilogram), velocity(metres_per_second(-1, 2, 0)));
    const auto b =
        world.add(position(metres(3.0, 2.0, 3.0)), mass(3.0 * kilogram), velocity(metres_per_second(3, -1, 5)));
    world.add(Spring{a, b, 0.0 * N_per_m, 0.0 * N_s_per_m, 1.2 * metre});
    world.step(0.0625 * second);
    // After the way of a step they are (2.25, -0.1875, 0.3125) apart; their middle of masses and its velocity stay.
    const Vector<double, 3> apart(2.25, -0.1875, 0.3125), u(4, -3, 5);
    const Vector<double, 3> axis = apart.normalized(), xa(1 - 0.0625, 2 + 0.125, 3);
    const double way = apart.norm() - 1.5, speed = u.dot(axis);
    REQUIRE(speed > 0);
    const double digits = 8 * std::numeric_limits<TestType>::epsilon();
    const auto off = [&](const auto& is, const Vector<double, 3>& should) {
        return (is.value().template cast<double>() - should).norm();
    };
    CHECK(off(world.position(a), xa + 0.75 * way * axis) < digits);
    CHECK(off(world.position(b), xa + apart - 0.25 * way * axis) < digits);
    CHECK(off(world.velocity(a), Vector<double, 3>(-1, 2, 0) + 0.75 * speed * axis) < digits);
    CHECK(off(world.velocity(b), Vector<double, 3>(3, -1, 5) - 0.25 * speed * axis) < digits);
    CHECK(double(largest_strain(world)) == Approx(0.25).epsilon(1e-6));
}

TEST_CASE("A limit keeps momentum, and takes energy of motion or leaves it", "[soft_bodies][strain_limit]") {
    const auto seed = GENERATE(1u, 2u, 3u, 4u);
    auto world = limited(StrainLimit<>{.most = 0.05, .passes = 7});
    world.set(Gravity{metres_per_second_squared(0, 0, 0)});
    add_net(world, seed);
    const auto momentum = total_momentum(world).value();
    double energy = kinetic_energy(world).value();
    CHECK(largest_strain(world) > 0.1);
    for (int i = 0; i < 50; ++i) {
        world.step(1e-2 * second);
        const double now = kinetic_energy(world).value();
        CHECK(now <= energy * (1 + 1e-14));
        energy = now;
    }
    CHECK((total_momentum(world).value() - momentum).norm() < 1e-12);
}

TEST_CASE("Switched on over a sheet that is stretched, it pulls together and gives no speed",
          "[soft_bodies][strain_limit]") {
    auto world = limited(StrainLimit<>{.most = 1000, .passes = 200});
    world.set(Gravity{metres_per_second_squared(0, 0, 0)});
    const auto parts = add_cloth(world, hung(6));
    for (const auto& body : parts.bodies)
        if (world.motion(body) == Motion::awake)
            world.set_position(body, world.position(body) + metres(0, 1.7 * world.position(body).value()[1], 0));
    for (const auto spring : world.elements<Spring>().handles()) { // springs that do nothing
        auto it = world.get(spring);
        it.stiffness = 0.0 * N_per_m;
        it.damping = 0.0 * N_s_per_m;
        world.set(spring, it);
    }
    CHECK(largest_strain(world) > 1);
    world.set(StrainLimit<>{.most = 0.1, .passes = 200});
    world.step(1e-3 * second);
    CHECK(largest_strain(world) < 0.101);
    CHECK(kinetic_energy(world).value() == 0);
}

TEST_CASE("Springs that are short enough do not feel it, to the bit", "[soft_bodies][strain_limit]") {
    auto with = limited(StrainLimit<>{.most = 10}), without = limited(StrainLimit<>{.most = 1e9});
    auto plain = limited();
    const auto parts = add_cloth(with, hung(6));
    add_cloth(without, hung(6));
    add_cloth(plain, hung(6));
    run(with, 200, 1e-3);
    run(without, 200, 1e-3);
    run(plain, 200, 1e-3);
    for (const auto& body : parts.bodies) {
        CHECK(with.position(body) == plain.position(body));
        CHECK(without.velocity(body) == plain.velocity(body));
    }
}

TEST_CASE("Behind a solver, with a point for an end, and for ropes that push nothing", "[soft_bodies][strain_limit]") {
    World world{SemiImplicitEuler{}, Gravity{}, Ropes<>{}, Xpbd{4, 1}, StrainLimit<Ropes<>>{.most = 0.02}};
    const auto ball = world.add(position(metres(0, -1, 0)), mass(2.0 * kilogram));
    const auto pin = world.add(position(metres(1, 0, 0)), fixed);
    world.add(Rope{ball, metres(0, 0, 0), 50.0 * N_per_m, 0.1 * N_s_per_m, 1.0 * metre});
    world.add(Rope{pin, ball, 50.0 * N_per_m, 0.1 * N_s_per_m, 1.45 * metre});
    double lowest = 0;
    for (int i = 0; i < 600; ++i) {
        world.step(1.0 / 60 * second);
        CHECK(largest_strain<Ropes<>>(world) <= 0.02 * (1 + 1e-9));
        lowest = std::min(lowest, world.position(ball).value()[1]);
    }
    CHECK(lowest < -1.01); // it hangs on the limit: its weight would stretch the rope by four tenths
    CHECK(world.position(pin).value() == Vector<double, 3>(1, 0, 0));
}

TEST_CASE("Springs and ropes of one world have each a limit of their own", "[soft_bodies][strain_limit]") {
    auto make = [] {
        return World{SemiImplicitEuler{},
                     Gravity{},
                     Springs<>{},
                     Ropes<>{},
                     StrainLimit<>{.most = 0.05},
                     StrainLimit<Ropes<>>{.most = 0.02}};
    };
    auto world = make();
    const auto first = world.add(position(metres(0, -1, 0)), mass(2.0 * kilogram));
    const auto second_ = world.add(position(metres(5, -1, 0)), mass(2.0 * kilogram));
    world.add(Spring{first, metres(0, 0, 0), 5.0 * N_per_m, 0.0 * N_s_per_m, 1.0 * metre});
    world.add(Rope{second_, metres(5, 0, 0), 5.0 * N_per_m, 0.0 * N_s_per_m, 1.0 * metre});
    run(world, 300, 1e-2);
    CHECK(world.position(first).value()[1] == Approx(-1.05).epsilon(1e-9));
    CHECK(world.position(second_).value()[1] == Approx(-1.02).epsilon(1e-9));
    std::stringstream file;
    save(world, file);
    auto loaded = make();
    load(loaded, file);
    CHECK(loaded.hash() == world.hash());
}

TEST_CASE("A limit is a parameter of a living world, copied, saved and loaded", "[soft_bodies][strain_limit]") {
    auto world = limited(StrainLimit<>{.most = 0.05, .passes = 5});
    add_net(world, 9);
    run(world, 10, 1e-2);
    world.set(StrainLimit<>{.most = 0.04, .passes = 3});
    auto copy = world;
    std::stringstream file;
    save(world, file);
    auto loaded = limited(StrainLimit<>{});
    load(loaded, file);
    CHECK(loaded.get<StrainLimit<>>().passes == 3);
    for (auto* each : {&world, &copy, &loaded}) run(*each, 10, 1e-2);
    CHECK(copy.hash() == world.hash());
    CHECK(loaded.hash() == world.hash());
}

TEST_CASE("A limit of bad numbers is refused", "[soft_bodies][strain_limit]") {
    auto world = limited(StrainLimit<>{});
    const auto hash = world.hash();
    CHECK_THAT(refusal([&] { world.set(StrainLimit<>{.most = 0}); }),
               ContainsSubstring("StrainLimit: most is 0") && ContainsSubstring("greater than zero"));
    CHECK_THAT(refusal([&] { world.set(StrainLimit<>{.most = NAN}); }), ContainsSubstring("most is nan"));
    CHECK_THAT(refusal([&] { world.set(StrainLimit<>{.most = INFINITY}); }), ContainsSubstring("most is inf"));
    CHECK_THAT(refusal([&] { world.set(StrainLimit<>{.passes = 0}); }), ContainsSubstring("passes is 0"));
    CHECK(world.hash() == hash);
}
