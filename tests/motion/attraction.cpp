// SPDX-License-Identifier: BSL-1.0

// Attraction: the force that couples bodies, and with it the third law and the conservation of momentum in a world.

#include <ansatz/motion/attraction.hpp>

#include "tests/motion/support.hpp"

using namespace motion_tests;

namespace {
Attraction of_one(double softening = 0) {
    Attraction a;
    a.constant = 1.0 * (cubic_metre / (kilogram * second * second));
    a.softening = softening * metre;
    return a;
}
/// Explicit one-step steppers of odeint are for single bodies, implicit Euler wants a Jacobian: not here.
using Coupling = Staged;

/// The angular momentum about the origin, of which a number is enough.
template <class World_> double angular_momentum_of(const World_& world) {
    const auto l = total_angular_momentum(world).value();
    if constexpr (World_::S::dimension == 2) return double(l);
    else return double(l.norm());
}
} // namespace

TEST_CASE("attraction: a light body about a heavy one moves as in a central field", "[motion][attraction]") {
    for_each_type(Types<VelocityVerlet, RungeKutta4>{}, []<class I> {
        // GM = 1 with a planet of no influence: Kepler's ellipse, whose place after a time is known.
        const auto start = kepler(0.3);
        check_order(I::order, 0.1, 200, 3, [&](int steps) {
            World world{Space<double, 2>{}, I{}, of_one()};
            world.add(mass(1.0 * kilogram));
            const auto planet = world.add(position(start.x), velocity(start.v), mass(1e-30 * kilogram));
            run(world, steps, 4.0 / steps);
            return distance(state(world, planet), state(kepler(0.3, 4.0)));
        });
    });
}

TEST_CASE("attraction: two bodies of comparable mass go round their centre of mass in Kepler's time",
          "[motion][attraction]") {
    // A circle: with distance d and masses m1, m2 the angular velocity is sqrt(G (m1 + m2) / d^3).
    for (const double ratio : {1.0, 3.0, 1e3}) {
        const double m1 = 2, m2 = 2 * ratio, d = 1.5, w = std::sqrt((m1 + m2) / (d * d * d)),
                     period = 2 * std::numbers::pi / w;
        const double r1 = d * m2 / (m1 + m2), r2 = d * m1 / (m1 + m2);
        World world{Space<double, 2>{}, RungeKutta4{}, of_one()};
        const auto first =
            world.add(position(metres(r1, 0)), velocity(metres_per_second(0, w * r1)), mass(m1 * kilogram));
        const auto second_one =
            world.add(position(metres(-r2, 0)), velocity(metres_per_second(0, -w * r2)), mass(m2 * kilogram));
        run(world, 2000, period / 2000);
        CHECK(std::abs(world.position(first).value()[0] - r1) <= 1e-9 * d);
        CHECK(std::abs(world.position(first).value()[1]) <= 1e-9 * d);
        CHECK(std::abs(world.position(second_one).value()[0] + r2) <= 1e-9 * d);
    }
}

TEST_CASE("attraction: a closed system keeps momentum, angular momentum and its centre, with every integrator",
          "[motion][attraction]") {
    for_each_type(Coupling{}, []<class I> {
        for_each_type(Types<Space<double, 3>, Space<float, 2>>{}, []<class S> {
            World world{S{}, I{}, of_one(0.2)};
            const double masses[] = {2, 1, 4, 0.5, 3};
            for (int i = 0; i < 5; ++i)
                world.add(at<S>(i, 0.5 * i * i - 3, i % 2), going<S>(0.3 * i - 0.5, 0.2, -0.1 * i),
                          mass(masses[i] * kilogram));
            const auto momentum = total_momentum(world);
            const auto centre = centre_of_mass(world);
            const auto drift = momentum / S::convert(10.5 * kilogram);
            const double angular = angular_momentum_of(world);
            run(world, 200, 0.01);
            const double size = 10; // the sum of m |v| is of this size, in kg m/s
            const double eps = std::numeric_limits<typename S::Scalar>::epsilon();
            // Verlet's velocity is a difference of positions, good to eps x / dt.
            const double roundings = (std::is_same_v<I, Verlet> ? 100 : 1) * 200 * 5 * eps * size;
            INFO("momentum " << momentum.value().transpose() << " became "
                             << total_momentum(world).value().transpose());
            CHECK(double((total_momentum(world) - momentum).value().norm()) <= roundings);
            const auto expected = centre + drift * S::convert(2.0 * second);
            CHECK(double((centre_of_mass(world) - expected).value().norm()) <= 200 * 10 * eps * size);
            // Forces along the line between the bodies exert no torque; explicit Euler and the stages in between do not
            // keep the cross product, the symplectic methods do.
            if constexpr (std::is_same_v<I, SemiImplicitEuler> || std::is_same_v<I, VelocityVerlet>)
                CHECK(std::abs(angular_momentum_of(world) - angular) <= 200 * 20 * eps * size);
        });
    });
}

TEST_CASE("attraction: energy is kept as well as the order allows, and its potential is the force's",
          "[motion][attraction]") {
    auto swing = [](int steps) {
        World world{Space<double, 2>{}, VelocityVerlet{}, of_one(0.1)};
        world.add(position(metres(0, 0)), mass(2.0 * kilogram));
        world.add(position(metres(2, 0)), velocity(metres_per_second(0, 1)), mass(1.0 * kilogram));
        const double before = total_energy(world).value();
        CHECK(std::abs(before - (0.5 - 2 / std::sqrt(4.01))) <= 1e-15);
        double most = 0;
        for (int i = 0; i < steps; ++i) {
            world.step(5.0 / steps * second);
            most = std::max(most, std::abs(total_energy(world).value() - before));
        }
        return most;
    };
    check_order(2, 0.1, 1000, 3, swing);
}

TEST_CASE("attraction: coincident bodies, fixed bodies and a lonely one give no NaN", "[motion][attraction]") {
    for_each_type(Coupling{}, []<class I> {
        World world{I{}, of_one()};
        const auto one = world.add(mass(1.0 * kilogram)), other = world.add(mass(1.0 * kilogram));
        const auto wall = world.add(position(metres(1, 0, 0)), fixed);
        run(world, 10, 0.1);
        CHECK(world.status().ok());
        CHECK(world.position(one).value() == Eigen::Vector3d::Zero());
        CHECK(world.position(other).value() == Eigen::Vector3d::Zero());
        CHECK(world.position(wall).value() == Eigen::Vector3d(1, 0, 0)); // immovable, and nothing feels it
        world.remove(other);
        run(world, 10, 0.1);
        CHECK(world.velocity(one).value() == Eigen::Vector3d::Zero());
    });
}

TEST_CASE("attraction: the order in which bodies were added and removed does not change a bit",
          "[motion][attraction]") {
    auto run_it = [](bool detour) {
        World world{VelocityVerlet{}, of_one(0.1)};
        std::vector<Handle> bodies;
        std::vector<Handle> gone;
        for (int i = 0; i < 4; ++i)
            bodies.push_back(world.add(position(metres(i, i * i, -i)), mass((1.0 + i) * kilogram)));
        if (detour) {
            for (int i = 0; i < 3; ++i) gone.push_back(world.add(position(metres(100, 3, i)), mass(1.0 * kilogram)));
            world.remove(gone[1]);
            world.remove(gone[0]);
            world.remove(gone[2]);
        }
        run(world, 100, 0.01);
        std::vector<Eigen::Vector3d> places;
        for (const auto body : bodies) places.push_back(world.position(body).value());
        return places;
    };
    CHECK(run_it(false) == run_it(true));
}

TEST_CASE("attraction refuses a negative constant and a softening that is no length", "[motion][attraction]") {
    auto with = [](double constant, double softening) {
        Attraction a = of_one(softening);
        a.constant = constant * (cubic_metre / (kilogram * second * second));
        return World{SemiImplicitEuler{}, a};
    };
    CHECK_NOTHROW(with(0, 0));
    CHECK_THROWS_AS(with(-1, 0), std::invalid_argument);
    CHECK_THROWS_AS(with(1, -0.1), std::invalid_argument);
    CHECK_THROWS_AS(with(std::nan(""), 0), std::invalid_argument);
    CHECK_THROWS_AS(with(1, INFINITY), std::invalid_argument);
}

TEST_CASE("attraction: planets fit into a float world, though the product of their masses does not",
          "[motion][attraction]") {
    World world{Space<float, 3>{}, VelocityVerlet{}, Attraction{}};
    const auto earth = world.add(mass(5.97e24 * kilogram));
    const auto moon =
        world.add(position(metres(3.84e8, 0, 0)), velocity(metres_per_second(0, 1022, 0)), mass(7.35e22 * kilogram));
    // G M / r^2 on the moon, G m / r^2 on the earth.
    CHECK(-x(world.acceleration(moon)).value() ==
          Catch::Approx(6.6743e-11 * 5.97e24 / (3.84e8 * 3.84e8)).epsilon(1e-5));
    CHECK(x(world.acceleration(earth)).value() ==
          Catch::Approx(6.6743e-11 * 7.35e22 / (3.84e8 * 3.84e8)).epsilon(1e-5));
    for (int i = 0; i < 24; ++i) world.step(3600.0 * second);
    CHECK(world.status().ok());
    CHECK(norm(world.position(moon)).value() == Catch::Approx(3.84e8).epsilon(0.02));
}
