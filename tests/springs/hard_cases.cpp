// SPDX-License-Identifier: BSL-1.0
// The hard cases of springs, S1 to S10, each by its name.
// Runs long with the sanitizers.

#include "tests/springs/support.hpp"

using namespace spring_tests;

namespace {

/// One mass of 1 kg on a spring of rest length 1 m along the first axis, stretched by `x0`.
template <class I, class S> auto on_a_spring(double k, double c, double x0) {
    World world{I{}, S{}, Springs{}};
    const auto body = world.add(at<S>(1 + x0), mass(1.0 * kilogram));
    world.add(Spring{point(world, 0), body, k * N_per_m, c * N_s_per_m, 1.0 * metre});
    return std::pair(world, body);
}
/// The same on a spring of rest length 0, which may swing through its own anchor.
template <class I, class S> auto on_a_spring_of_no_length(double k, double c, double x0) {
    World world{I{}, S{}, Springs{}};
    const auto body = world.add(at<S>(x0), mass(1.0 * kilogram));
    world.add(Spring{point(world, 0), body, k * N_per_m, c * N_s_per_m, 0.0 * metre});
    return std::pair(world, body);
}
template <class World_> double place(const World_& world, Handle body) {
    return double(world.position(body).value()[0]) - 1;
}

/// The largest displacement in so many steps.
template <class World_> double reach(World_& world, Handle body, int steps, double dt) {
    double most = 0;
    for (int i = 0; i < steps; ++i) {
        world.step(dt * second);
        most = std::max(most, std::abs(place(world, body)));
    }
    return std::isfinite(most) ? most : 1e300;
}

} // namespace

TEST_CASE("S1: the implicit step of a damped spring is its closed recurrence", "[springs][hard]") {
    const auto m = 1.0 * kilogram;
    const double k = springs::stiffness(2.0 / second, m).value(), c = springs::damping(2.0 / second, 0.1, m).value(),
                 h = 1.0 / 60;
    for_each_type(AllSpaces{}, [&]<class S>() {
        for_each_type(Types<ImplicitEuler, ImplicitEulerDirect>{}, [&]<class I>() {
            auto [world, body] = on_a_spring_of_no_length<I, S>(k, c, 10);
            double x = 10, v = 0;
            for (int i = 0; i < 120; ++i) {
                v = (v - h * k * x) / (1 + h * c + h * h * k);
                x += h * v;
                world.step(h * second);
                REQUIRE(std::abs(double(world.position(body).value()[0]) - x) <=
                        (std::is_same_v<typename S::Scalar, float>
                             ? 5e-5
                             : 1e-9)); // measured 2e-5 and 2e-14; Jolt's bound is 5e-6 of 10 m
            }
            CHECK(world.status().ok());
        });
    });
}

TEST_CASE("S2: the damped spring in its three regimes, by its closed form and with the order of each method",
          "[springs][hard]") {
    const double k = 100, x0 = 0.5;
    for (const double zeta : {0.1, 1.0, 10.0}) {
        INFO("zeta " << zeta);
        const double w = std::sqrt(k), c = 2 * zeta * w;
        const double T = zeta > 1 ? 0.02 : 1; // while what decays fast is still there
        auto exact = [&](double t) {
            if (zeta < 1) {
                const double wd = w * std::sqrt(1 - zeta * zeta);
                return x0 * std::exp(-zeta * w * t) * (std::cos(wd * t) + zeta * w / wd * std::sin(wd * t));
            }
            if (zeta == 1) return x0 * std::exp(-w * t) * (1 + w * t);
            const double s = w * std::sqrt(zeta * zeta - 1), a = -zeta * w + s, b = -zeta * w - s;
            return x0 * (a * std::exp(b * t) - b * std::exp(a * t)) / (a - b);
        };
        for_each_type(AllIntegrators{}, [&]<class I>() {
            if constexpr (std::same_as<I, OdeintFehlberg78>) return;
            const double order = std::same_as<I, OdeintRungeKutta4> ? 4 : I::order;
            check_order(order, 0.12, order == 4 ? (zeta > 1 ? 25 : 200) : 1600, 3, [&](int steps) {
                auto [world, body] = on_a_spring<I, Space<>>(k, c, x0);
                run(world, steps, T / steps);
                return std::abs(place(world, body) - exact(T));
            });
        });
        if (zeta >= 1) // never swings over
            for_each_type(
                Types<SemiImplicitEuler, VelocityVerlet, Verlet, RungeKutta4, ImplicitEuler>{}, [&]<class I>() {
                    auto [world, body] = on_a_spring<I, Space<>>(k, c, x0);
                    for (int i = 0; i < 2400; ++i) {
                        world.step(1.0 / 240 * second);
                        REQUIRE(place(world, body) >=
                                (std::same_as<I, Verlet>
                                     ? -1e-12
                                     : -1e-14)); // the rounding of 1 m; in Verlet it is also one of the velocity
                    }
                });
    }
}

TEST_CASE("S3: k = 1e6 N/m: the limit is 2 ms to the last thousandth, and implicit Euler takes 60 Hz",
          "[springs][hard]") {
    for_each_type(AllSpaces{}, [&]<class S>() {
        for_each_type(Types<SemiImplicitEuler, VelocityVerlet, Verlet>{}, [&]<class I>() {
            // The step that a float holds is not quite the one that was asked for: within a thousandth nothing depends
            // on it.
            auto [below, a] = on_a_spring<I, S>(1e6, 0, 1e-3);
            auto [above, b] = on_a_spring<I, S>(1e6, 0, 1e-3);
            CHECK(reach(below, a, 2000, 0.001998) <= 0.1);
            CHECK(reach(above, b, 400, 0.002002) >= 1);
            CHECK(in(stable_step(below), second) == Approx(0.002).epsilon(1e-9));
        });
        auto [world, body] = on_a_spring<ImplicitEuler, S>(1e6, 0, 1e-3);
        CHECK(reach(world, body, 120, 1.0 / 60) <= 1e-3);
        CHECK(std::abs(place(world, body)) <= 2e-7);
        CHECK(world.status().ok());
    });
}

TEST_CASE("S4: coincident ends, rest length 0 and 1, in every integrator: finite, and nothing moves that should not",
          "[springs][hard]") {
    for_each_type(AllIntegrators{}, [&]<class I>() {
        for (const double rest : {0.0, 1.0}) {
            World world{I{}, Springs{}, Ropes{}};
            const auto a = world.add(position(metres(1, 2, 3)), mass(1.0 * kilogram));
            const auto b = world.add(position(metres(1, 2, 3)), mass(2.0 * kilogram));
            world.add(Spring{a, b, 100.0 * N_per_m, 1.0 * N_s_per_m, rest * metre});
            world.add(Rope{a, b, 100.0 * N_per_m, 1.0 * N_s_per_m, rest * metre});
            run(world, 100, 0.01);
            CHECK(world.position(a) == metres(1, 2, 3));
            CHECK(world.position(b) == metres(1, 2, 3));
            // Parted by the smallest push they behave as springs do.
            world.apply_impulse(a, newton_seconds(1e-3, 0, 0));
            run(world, 1000, 0.001);
            CHECK(world.status().ok());
            CHECK(norm(world.position(a) - world.position(b)).value() <= (rest == 0 ? 1e-4 : 2.5));
        }
    });
}

TEST_CASE("S5: two free masses, 1 : 1000: the centre of mass stays, and the pair swings with its reduced mass",
          "[springs][hard]") {
    const double k = 1e3, m = 1, M = 1000, mu = m * M / (m + M), omega = std::sqrt(k / mu), h = 1e-3;
    for_each_type(Types<SemiImplicitEuler, VelocityVerlet, Verlet>{}, [&]<class I>() {
        World world{I{}, Springs{}};
        const auto a = world.add(position(metres(1.1, 0, 0)), velocity(metres_per_second(0, 0, 0)), mass(m * kilogram));
        const auto b = world.add(position(metres(0, 0, 0)), mass(M * kilogram));
        world.add(Spring{a, b, k * N_per_m, {}, 1.0 * metre});
        const double centre = x(centre_of_mass(world)).value();
        double last = 0.1, first_cross = 0, last_cross = 0;
        int crossings = 0;
        for (int i = 1; i <= 20000; ++i) {
            world.step(h * second);
            const double stretched = x(world.position(a) - world.position(b)).value() - 1;
            if (last > 0 && stretched <= 0) { // the time between, by the line through both
                last_cross = h * (i - 1 + last / (last - stretched));
                if (crossings++ == 0) first_cross = last_cross;
            }
            last = stretched;
        }
        // The discrete frequency: 2 asin(omega h / 2) / h, faster than omega by (omega h)^2 / 24.
        const double measured = 2 * M_PI * (crossings - 1) / (last_cross - first_cross);
        CHECK(measured / omega - 1 == Approx(omega * omega * h * h / 24).epsilon(0.02).margin(2e-7));
        CHECK(std::abs(x(centre_of_mass(world)).value() - centre) <=
              1e-13 * 20); // of 20 s of steps that round at 1e-16
    });
}

TEST_CASE("S6: a hanging chain: the static stretch, and the sharp limit of the step", "[springs][hard]") {
    const int N = 20;
    const double m = 0.05, k = 500, g = 9.81, stretch = m * g * N * (N + 1) / 2 / k;
    CHECK(stretch == Approx(0.206010));
    World settled{ImplicitEuler{}, Gravity{}, Springs{}};
    const auto quiet = hang_chain(settled, N, m, k, 0.5, 0.1);
    run(settled, 3000, 0.05);
    CHECK(-height(settled, quiet.back()) - 0.1 * N == Approx(stretch).margin(1e-6));

    const double limit = std::sqrt(m / k) / std::cos(M_PI / (2 * N + 1));
    CHECK(limit == Approx(0.0100293).epsilon(2e-5)); // to the digits of the catalogue
    for_each_type(Types<SemiImplicitEuler, VelocityVerlet, Verlet>{}, [&]<class I>() {
        auto lowest = [&](double h) {
            World world{I{}, Gravity{}, Springs{}};
            const auto chain = hang_chain(world, N, m, k, 0, 0.1);
            double most = 0;
            for (int i = 0; i < 20000; ++i) {
                world.step(h * second);
                const double stretched = -height(world, chain.back()) - 0.1 * N;
                most = std::max(most, std::isfinite(stretched) ? std::abs(stretched) : 1e300);
                if (most > 1e3) break;
            }
            return most;
        };
        CHECK(lowest(0.999 * limit) <= 2.05 * stretch); // measured 0.4123, 2.001 times the static stretch
        CHECK(lowest(1.001 * limit) >= 1e3);
    });
    World chain{SemiImplicitEuler{}, Gravity{}, Springs{}};
    hang_chain(chain, N, m, k, 0, 0.1);
    CHECK(in(stable_step(chain), second) <= limit);
    CHECK(in(stable_step(chain), second) >= 0.996 * limit); // cos(pi / 41)
    CHECK(2 / std::sqrt(measured_stiffness(chain).value()) == Approx(limit).epsilon(1e-4));
}

TEST_CASE("S8: ball and chain, 40 links, the end 200 times as heavy", "[springs][hard]") {
    const int N = 40;
    const double m = 0.05, M = 200 * m, k = 2e4, g = 9.81;
    World world{ImplicitEuler{}, Gravity{}, Springs{}};
    const auto chain = hang_chain(world, N, m, k, 50, 0.1, M);
    run(world, 2000, 0.05);
    const double stretch = -height(world, chain.back()) - 0.1 * N;
    CHECK(stretch == Approx((N * M + m * (N - 1) * N / 2) * g / k)
                         .epsilon(0.01)); // the end itself is not one of the N - 1 light ones
    CHECK(world.status().ok());
}

TEST_CASE("S9: driven at resonance: the amplitude that the damper allows, and no energy creeps", "[springs][hard]") {
    const double k = 100, c = 0.4, F = 0.2, omega = 10, h = 0.001;
    for_each_type(Types<SemiImplicitEuler, VelocityVerlet, Verlet, RungeKutta4>{}, [&]<class I>() {
        World world{I{}, Springs{}, AppliedForces{}};
        const auto body = world.add(position(metres(1, 0, 0)), mass(1.0 * kilogram));
        world.add(Spring{metres(0, 0, 0), body, k * N_per_m, c * N_s_per_m, 1.0 * metre});
        double early = 0, late = 0;
        for (int i = 0; i < 200000; ++i) {
            world.apply_force(body, newtons(F * std::sin(omega * h * (i + 0.5)), 0, 0));
            world.step(h * second);
            const double now = std::abs(place(world, body));
            if (i >= 60000 && i < 70000) early = std::max(early, now); // 12 times the time in which it settles
            if (i >= 190000) late = std::max(late, now);
        }
        CHECK(late == Approx(F / (c * omega)).epsilon(0.01));
        CHECK(late == Approx(early).epsilon(1e-4));
    });
}

TEST_CASE("S10: a falling load is caught by a rope: never pushed, and the peak of the pull is what energy allows",
          "[springs][hard]") {
    const double k = 400, m = 2, g = 9.81;
    for_each_type(Types<SemiImplicitEuler, VelocityVerlet, Verlet, RungeKutta4, ImplicitEuler>{}, [&]<class I>() {
        World world{I{}, Gravity{}, Ropes{}};
        const auto load = world.add(position(metres(0, 0, 0)), mass(m * kilogram));
        world.add(Rope{.first = metres(0, 0, 0), .second = load, .stiffness = k * N_per_m, .rest_length = 2.0 * metre});
        double peak = 0, fastest = 0;
        for (int i = 0; i < 6000; ++i) {
            world.step(0.0005 * second);
            const double pull = m * (y(world.acceleration(load)).value() + g);
            REQUIRE(pull >= -1e-9);
            peak = std::max(peak, pull);
            fastest = std::max(fastest, -y(world.velocity(load)).value());
            if (height(world, load) > -2) REQUIRE(std::abs(pull) <= 1e-9); // slack
        }
        // v is the greatest speed, which the load has where the rope holds its weight, not where it becomes taut.
        CHECK(peak <= (fastest * std::sqrt(k * m) + m * g) * 1.001);
        const double v = std::sqrt(2 * g * 2);
        const double exact =
            m * g + std::sqrt(m * m * g * g + v * v * k * m); // kinetic and potential energy against k x^2 / 2
        CHECK(peak == Approx(exact).epsilon(std::same_as<I, ImplicitEuler> ? 0.03 : 0.005));
    });
}
