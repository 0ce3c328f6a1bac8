// SPDX-License-Identifier: BSL-1.0
// SoftSubsteps: energy comes from nowhere (hard case V3), a load that goes leaves the others where they are (V4, R7),
// and what bodies do that meet at one moment.
// Runs long with the sanitizers.

#include "tests/collision/support.hpp"
#include <ansatz/collision/response/soft_impacts.hpp>
#include <ansatz/collision/response/soft_loads.hpp>

#include <ansatz/collision/response/soft_substeps.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <string>

using namespace collision_tests;

namespace {
constexpr double dt = 1.0 / 60, g = 9.81; // s, m/s^2

template <class World_>
double kinetic_energy(const World_& world, const std::vector<Handle>& bodies, const std::vector<double>& masses) {
    double sum = 0;
    for (std::size_t i = 0; i < bodies.size(); ++i)
        sum += 0.5 * masses[i] * double(squared_norm(world.velocity(bodies[i])).value());
    return sum;
}
void add_walls(auto& world, double half, double e) {
    for (int k = 0; k < 3; ++k)
        for (const double side : {-1.0, 1.0}) {
            Eigen::Vector3d inwards = Eigen::Vector3d::Zero();
            inwards[k] = side;
            world.add(Plane{inwards, -half * metre}, fixed, restitution(e));
        }
}

struct Gas {
    int bodies;
    double speed; // m/s
    double e;
    int parts;
    bool boxes; // every third of them
    unsigned seed;
};
/// Bodies of 0.1 m that fly about in a closed box, nothing else: the largest gain of energy in a step, relative to the
/// start.
template <class... P> double largest_gain(const Gas& gas, int steps, P... policies) {
    SoftSubsteps<> response;
    response.parts = gas.parts;
    World world{SemiImplicitEuler{}, UniformGrid{}, response, policies...};
    const double r = 0.1, half = gas.bodies > 30 ? 2.5 : 0.9;
    add_walls(world, half, gas.e);
    std::mt19937 random(gas.seed);
    std::uniform_real_distribution<double> between(-1, 1);
    const int side = int(std::ceil(std::cbrt(double(gas.bodies))));
    const double apart = 2 * (half - 0.2) / side;
    std::vector<Handle> bodies;
    std::vector<double> masses;
    for (int i = 0; i < gas.bodies; ++i) {
        const Eigen::Vector3d cell(i % side, i / side % side, i / side / side);
        const double loose = std::max(0.0, apart / 2 - 0.15);
        Eigen::Vector3d x = (cell.array() + 0.5 - 0.5 * side) * apart, v;
        for (int k = 0; k < 3; ++k) x[k] += loose * between(random);
        do
            for (int k = 0; k < 3; ++k) v[k] = between(random);
        while (v.norm() > 1 || v.norm() < 0.1);
        v *= gas.speed / v.norm();
        masses.push_back(i % 4 == 0 ? 5.0 : 1.0);
        const auto where = position(x * metre);
        const auto how = velocity(v * metre_per_second);
        bodies.push_back(
            gas.boxes && i % 3 == 0
                ? world.add(Box{metres(r, r, r)}, where, how, mass(masses.back() * kilogram), restitution(gas.e))
                : world.add(Sphere{r * metre}, where, how, mass(masses.back() * kilogram), restitution(gas.e)));
    }
    const double start = kinetic_energy(world, bodies, masses);
    double before = start, most = 0;
    for (int i = 0; i < steps; ++i) {
        world.step(dt * second);
        const double now = kinetic_energy(world, bodies, masses);
        most = std::max(most, (now - before) / start);
        before = now;
    }
    return most;
}
/// Every number of bodies, speed, division and coefficient that the law names, a few at a time.
template <class... P> void check_gases(P... policies) {
    unsigned seed = 0;
    for (const double radii_a_step : {0.01, 0.1, 1.0, 3.0, 10.0, 50.0})
        for (const double e : {0.0, 0.5, 1.0})
            for (const int bodies : {1, 2, 7, 30, 250}) {
                ++seed;
                const int parts = std::array{4, 1, 16, 2, 7}[seed % 5];
                const Gas gas{bodies, radii_a_step * 0.1 / dt, e, parts, seed % 2 == 0, seed};
                INFO(bodies << " bodies, " << radii_a_step << " radii a step, e = " << e << ", " << parts
                            << " substeps, " << (gas.boxes ? "with boxes" : "spheres"));
                CHECK(largest_gain(gas, bodies > 100 ? 60 : 120, policies...) <= 1e-12);
            }
}
} // namespace

TEST_CASE("V3: SoftSubsteps makes no energy from nothing", "[collision][soft]") {
    check_gases(Narrowphase<Sphere, Plane, Box>{});
}

TEST_CASE("V3: nor does it under Swept", "[collision][soft]") { check_gases(Swept<Narrowphase<Sphere, Plane, Box>>{}); }

TEST_CASE("V3: 120 balls at 60 m/s with e = 1 in a box of 20 m", "[collision][soft]") {
    auto world = World{SemiImplicitEuler{}, UniformGrid{}, SoftSubsteps<>{}, Narrowphase<Sphere, Plane, Box>{}};
    add_walls(world, 10, 1);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> between(-1, 1);
    std::vector<Handle> balls;
    for (int i = 0; i < 120; ++i) {
        Eigen::Vector3d v(between(random), between(random), between(random));
        v *= 60 / v.norm();
        const auto where = metres(-8.0 + 4 * (i % 5), -8.0 + 4 * (i / 5 % 5), -8.0 + 4 * (i / 25));
        balls.push_back(world.add(Sphere{0.1 * metre}, position(where), velocity(v * metre_per_second),
                                  mass(1.0 * kilogram), restitution(1)));
    }
    const std::vector<double> masses(120, 1.0);
    const double start = kinetic_energy(world, balls, masses);
    double before = start;
    for (int i = 0; i < 500; ++i) {
        world.step(dt * second);
        const double now = kinetic_energy(world, balls, masses);
        CHECK(now <= before + 1e-12 * start);
        before = now;
    }
    // What is lost are approaches below the threshold, of two that graze each other.
    CHECK(before >= 0.99 * start);
}

namespace {
/// 120 balls in a closed box of 20 m (in the plane 100) that gravity pulls at: the largest gain of kinetic energy and
/// height in a step, and over what it was at the start, relative to that.
struct Gains {
    double step = 0, over_all = 0, left = 1;
};
template <class S, class I, class Soft>
Gains gains_in_gravity(I integrator, Soft response, double speed, double e, double mu, int steps) {
    constexpr bool flat = S::dimension == 2;
    World world{integrator, S{}, Gravity{}, UniformGrid{}, Narrowphase<Sphere, Plane, Box>{}, response};
    const auto rough = [&](Handle body) {
        if constexpr (decltype(world)::composition::template stores<Friction>)
            world.template write<Friction>(body, Quantity<unit::Dimensionless>(mu));
        return body;
    };
    for (int k = 0; k < S::dimension; ++k)
        for (const double side : {-1.0, 1.0})
            rough(world.add(Plane{Eigen::Vector3d(side * Eigen::Vector3d::Unit(k)), -10.0 * metre}, fixed,
                            restitution(e)));
    std::mt19937 random(3);
    std::uniform_real_distribution<double> between(-1, 1);
    std::vector<Handle> balls;
    for (int i = 0; i < (flat ? 100 : 120); ++i) {
        Eigen::Vector3d v(between(random), between(random), flat ? 0 : between(random));
        v *= speed / v.norm();
        const auto where = flat ? at<S>(-8.5 + 1.8 * (i % 10), -8.5 + 1.8 * (i / 10))
                                : at<S>(-8.0 + 4 * (i % 5), -8.0 + 4 * (i / 5 % 5), -8.0 + 4 * (i / 25));
        balls.push_back(
            rough(world.add(Sphere{0.1 * metre}, where, velocity(vector_in<S, unit::Velocity>(v[0], v[1], v[2])),
                            mass(1.0 * kilogram), restitution(e))));
    }
    // A velocity of semi-implicit Euler is that of half a part before the place: with what gravity does until then
    // energy is exact.
    const double late = std::is_same_v<I, SemiImplicitEuler> ? g * dt / response.parts / 2 : 0;
    const auto energy = [&] {
        double sum = 0;
        for (const auto ball : balls) {
            const auto v = world.velocity(ball).value();
            for (int k = 0; k < S::dimension; ++k) {
                const double now = double(v[k]) - (k == 1 ? late : 0);
                sum += now * now / 2;
            }
            sum += g * (height_of(world, ball) + 10);
        }
        return sum;
    };
    const double start = energy();
    double before = start;
    Gains gains;
    for (int i = 0; i < steps; ++i) {
        world.step(dt * second);
        const double now = energy();
        gains.step = std::max(gains.step, (now - before) / start);
        gains.over_all = std::max(gains.over_all, (now - start) / start);
        before = now;
    }
    gains.left = before / start;
    return gains;
}
} // namespace

TEST_CASE("V3: nor with gravity, in float, in two dimensions and with friction: kinetic energy and height",
          "[collision][soft]") {
    auto check = []<class S>(S, auto integrator, auto response, double most) {
        for (const double speed : {1.0, 6.0, 60.0})
            for (const double e : {0.0, 0.5, 1.0}) {
                const auto gains = gains_in_gravity<S>(integrator, response, speed, e, 0.5, 500);
                INFO(speed << " m/s, e = " << e << ": in a step " << gains.step << ", in all " << gains.over_all
                           << ", left " << gains.left);
                CHECK(gains.over_all <= most);
                if (e == 1) CHECK(gains.step <= most);
                // Held softly, what lies may be given 16 times the energy that gravity gives it in a substep (`calm`).
                else CHECK(gains.step <= most + 4 * 16 * 0.5 * std::pow(g * dt / 4, 2) / (g * 9));
            }
    };
    const double exact = 1e-12, single = 1e-5; // of sums of 120 in numbers of 24 bits
    check(Space<>{}, SemiImplicitEuler{}, SoftSubsteps<>{}, exact);
    check(Space<>{}, VelocityVerlet{}, SoftSubsteps<>{}, exact);
    check(Space<>{}, SemiImplicitEuler{}, SoftSubsteps<Friction>{}, exact);
    check(Space<double, 2>{}, SemiImplicitEuler{}, SoftSubsteps<Friction>{}, exact);
    check(Space<float, 3>{}, SemiImplicitEuler{}, SoftSubsteps<>{}, single);
    check(Space<float, 2>{}, SemiImplicitEuler{}, SoftSubsteps<Friction>{}, single);
}

// ------------------------------------------------------------------------------------------------ loads that go (V4,
// R7)

namespace {
enum class Relief { removed, lighter, gravity_off, gravity_halved };
struct Column {
    double load; // the mass of the top one over that of the others
    int height;  // how many, with the load
    bool boxes;
    Relief relief;
};
struct Unloaded {
    double rise = 0;   // how far one comes above its place in the column that nothing presses, m
    double speed = 0;  // the fastest of them in the last second, m/s
    double before = 0; // and before it happened
};
/// A column that has lain for half a minute loses its load, and is watched while what is left settles: for five
/// seconds, or where the load stays and weighs half, for the fifteen that the column took to stand under it, at 300:1.
template <class... P> Unloaded unload(const Column& column, double mu, P... policies) {
    World world{SemiImplicitEuler{}, Gravity{}, BoundingBoxes{}, Narrowphase<Sphere, Plane, Box>{}, policies...};
    const auto with_friction = [&](Handle body) {
        if constexpr (decltype(world)::composition::template stores<Friction>)
            world.template write<Friction>(body, Quantity<unit::Dimensionless>(mu));
        return body;
    };
    with_friction(world.add(Plane::ground(), fixed));
    std::vector<Handle> bodies;
    for (int i = 0; i < column.height; ++i) {
        const auto m = mass((i + 1 == column.height ? column.load : 1.0) * kilogram);
        const auto where = at<Space<>>(0, 0.5 + i);
        bodies.push_back(with_friction(column.boxes ? world.add(Box{metres(0.5, 0.5, 0.5)}, where, m)
                                                    : world.add(Sphere{0.5 * metre}, where, m)));
    }
    run(world, 1800, dt);
    Unloaded result;
    for (const auto body : bodies) result.before = std::max(result.before, double(norm(world.velocity(body)).value()));
    switch (column.relief) {
    case Relief::removed:
        world.remove(bodies.back());
        bodies.pop_back();
        break;
    case Relief::lighter: world.set_mass(bodies.back(), 1.0 * kilogram); break;
    case Relief::gravity_off: world.set(Gravity{metres_per_second_squared(0, 0, 0)}); break;
    case Relief::gravity_halved: world.set(Gravity{metres_per_second_squared(0, -g / 2, 0)}); break;
    }
    const int steps = column.relief == Relief::gravity_halved ? 900 : 300;
    for (int i = 0; i < steps; ++i) {
        world.step(dt * second);
        for (std::size_t k = 0; k < bodies.size(); ++k) {
            result.rise = std::max(result.rise, height_of(world, bodies[k]) - (0.5 + double(k)));
            if (i >= steps - 60) result.speed = std::max(result.speed, double(norm(world.velocity(bodies[k])).value()));
        }
    }
    return result;
}
} // namespace

TEST_CASE("V4, R7: what loses the load upon it stays where it is", "[collision][soft]") {
    auto check = [](double mu, auto... policies) {
        for (const double load : {1.0, 10.0, 60.0, 100.0, 300.0})
            for (const int height : {3, 6, 10})
                for (const auto relief :
                     {Relief::removed, Relief::lighter, Relief::gravity_off, Relief::gravity_halved})
                    for (const bool boxes : {false, true}) {
                        const auto seen = unload({load, height, boxes, relief}, mu, policies...);
                        const char* const what[] = {"removed", "lighter", "no gravity", "half of gravity"};
                        INFO(height << (boxes ? " boxes, " : " spheres, ") << load << ":1, "
                                    << what[std::size_t(relief)]);
                        INFO("moving at " << seen.before << " m/s before");
                        CHECK(seen.rise <= 1e-3);
                        CHECK(seen.speed <= 0.05);
                    }
    };
    check(0, SoftSubsteps<>{});
    check(0.5, SoftSubsteps<Friction>{}, Rest{});
}

// ------------------------------------------------------------------------------------------------ impacts at one
// moment

namespace {
/// Balls of radius 0.5 m in a row that touch, added in some order; their velocities after the impact, by their places
/// in the row.
template <class Response>
std::vector<double> cradle(const std::vector<double>& speeds, const std::vector<double>& masses,
                           const std::vector<std::size_t>& order, double gap, double e, Response response, int steps) {
    auto world = World{SemiImplicitEuler{}, BoundingBoxes{}, Narrowphase<Sphere, Plane, Box>{}, response};
    std::vector<Handle> balls(speeds.size());
    for (const auto i : order)
        balls[i] = world.add(Sphere{0.5 * metre}, at<Space<>>((1 + gap) * double(i)), going<Space<>>(speeds[i]),
                             mass(masses[i] * kilogram), restitution(e));
    run(world, steps, dt);
    std::vector<double> after;
    for (const auto ball : balls) after.push_back(speed_along(world, ball));
    return after;
}
} // namespace

TEST_CASE("SoftSubsteps: five balls are a cradle, whatever the order in which they were added", "[collision][soft]") {
    std::mt19937 random(11);
    std::vector<std::size_t> order(5);
    std::iota(order.begin(), order.end(), 0);
    const std::vector<double> alike(5, 1.0);
    for (int n = 0; n < 12; ++n) {
        for (const double gap : {0.0, 1e-3}) {
            for (int coming = 1; coming < 5; ++coming) {
                std::vector<double> speeds(5, 0.0);
                for (int i = 0; i < coming; ++i) speeds[std::size_t(i)] = 1;
                const auto after = cradle(speeds, alike, order, gap, 1, SoftSubsteps<>{}, 30);
                for (int i = 0; i < 5; ++i) {
                    INFO(coming << " of five, " << gap << " m apart, ball " << i);
                    CHECK(std::abs(after[std::size_t(i)] - (i >= 5 - coming ? 1 : 0)) <= 1e-12);
                }
            }
        }
        // From both sides at once: it goes back as it came.
        const auto mirrored = cradle({1, 0, 0, 0, -1}, alike, order, 0, 1, SoftSubsteps<>{}, 30);
        for (int i = 0; i < 5; ++i)
            CHECK(std::abs(mirrored[std::size_t(i)] - std::array{-1, 0, 0, 0, 1}[std::size_t(i)]) <= 1e-12);
        // Unequal ones: each with the next, as if there were a gap between them.
        const std::vector<double> masses{3, 1, 2, 5, 1};
        const auto unequal =
            cradle({1, 0, 0, 0, 0}, masses, order, 0, 1, SoftSubsteps<>{.threshold = 0.0 * metre_per_second}, 30);
        double momentum = 0, energy = 0;
        for (std::size_t i = 0; i < 5; ++i)
            momentum += masses[i] * unequal[i], energy += 0.5 * masses[i] * unequal[i] * unequal[i];
        CHECK(std::abs(momentum - 3) <= 1e-12);
        CHECK(std::abs(energy - 1.5) <= 1e-12);
        for (std::size_t i = 0; i + 1 < 5; ++i)
            CHECK(unequal[i] <= unequal[i + 1] + 1e-12); // no body runs into the next any more
        const auto in_order = cradle({1, 0, 0, 0, 0}, masses, {0, 1, 2, 3, 4}, 0, 1,
                                     SoftSubsteps<>{.threshold = 0.0 * metre_per_second}, 30);
        for (std::size_t i = 0; i < 5; ++i) CHECK(std::abs(unequal[i] - in_order[i]) <= 1e-12);
        std::shuffle(order.begin(), order.end(), random);
    }
}

TEST_CASE("SoftSubsteps: one ball that meets two at one moment separates from both as symmetry and energy demand",
          "[collision][soft]") {
    // A ball of 1 kg at 1 m/s between two of 1 kg: the normals are at 30 degrees to its way. It goes back at 1/5, they
    // leave at 2 sqrt(3) / 5 each: momentum 1 = -1/5 + 2 cos(30) 2 sqrt(3) / 5, energy 1 = 1/25 + 2 * 12/25.
    for (int n = 0; n < 6; ++n) {
        auto world = World{SemiImplicitEuler{}, BoundingBoxes{}, Narrowphase<Sphere, Plane, Box>{}, SoftSubsteps<>{}};
        std::array<Handle, 3> balls;
        const std::array<Eigen::Vector3d, 3> places{Eigen::Vector3d(-std::sqrt(0.75) - 0.01, 0, 0),
                                                    Eigen::Vector3d(0, 0.5, 0), Eigen::Vector3d(0, -0.5, 0)};
        const std::array<std::array<std::size_t, 3>, 6> orders{
            {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
        for (const auto i : orders[std::size_t(n)])
            balls[i] = world.add(Sphere{0.5 * metre}, position(places[i] * metre), going<Space<>>(i == 0 ? 1 : 0),
                                 mass(1.0 * kilogram), restitution(1));
        run(world, 30, dt);
        CHECK(std::abs(speed_along(world, balls[0], 0) + 0.2) <=
              0.01); // where they touch the normals are those of a hundredth before
        CHECK(std::abs(speed_along(world, balls[0], 1)) <= 1e-12);
        CHECK(std::abs(speed_along(world, balls[1], 0) - speed_along(world, balls[2], 0)) <= 1e-12);
        CHECK(std::abs(speed_along(world, balls[1], 1) + speed_along(world, balls[2], 1)) <= 1e-12);
        CHECK(std::abs(kinetic_energy(world, {balls[0], balls[1], balls[2]}, {1, 1, 1}) - 0.5) <= 1e-12);
    }
}
