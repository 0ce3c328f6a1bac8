// SPDX-License-Identifier: BSL-1.0
// The largest stable step: closed forms, both sides of it by running, and the bound against eigenvalues.
// Runs long with the sanitizers.

#include <ansatz/springs/stable_step.hpp>

#include "tests/springs/support.hpp"

#include <Eigen/Eigenvalues>

#include <random>

using namespace spring_tests;
using Catch::Matchers::ContainsSubstring;

namespace {
auto per_s2(double x) { return x / (second * second); }
template <class I> double limit(double k, double c = 0) { return in(stable_step<I>(per_s2(k), c / second), second); }
} // namespace

TEST_CASE("the limit of each method is its closed form, at any scale", "[springs]") {
    for (const double k : {1e-6, 1.0, 100.0, 1e6, 1e12}) {
        const double w = std::sqrt(k);
        CHECK(limit<SemiImplicitEuler>(k) == Approx(2 / w).epsilon(1e-9));
        CHECK(limit<VelocityVerlet>(k) == Approx(2 / w).epsilon(1e-9));
        CHECK(limit<Verlet>(k) == Approx(2 / w).epsilon(1e-9));
        CHECK(limit<RungeKutta4>(k) == Approx(std::sqrt(8.0) / w).epsilon(1e-6));
        CHECK(limit<OdeintRungeKutta4>(k) == Approx(std::sqrt(8.0) / w).epsilon(1e-6));
        CHECK(limit<ExplicitEuler>(k) == 0);
        CHECK(limit<ImplicitEuler>(k) == INFINITY);
        for (const double zeta : {0.01, 0.5, 1.0, 10.0}) {
            const double c = 2 * zeta * w;
            CHECK(limit<SemiImplicitEuler>(k, c) ==
                  Approx((std::sqrt(c * c + 4 * k) - c) / k).epsilon(1e-9)); // hard case I6
            // Explicit Euler needs damping: c/k while it swings, 2 over the faster rate when it creeps.
            CHECK(limit<ExplicitEuler>(k, c) ==
                  Approx(zeta < 1 ? c / k : 2 / (0.5 * (c + std::sqrt(c * c - 4 * k)))).epsilon(1e-6));
            CHECK(limit<ImplicitEuler>(k, c) == INFINITY);
        }
    }
    CHECK(limit<SemiImplicitEuler>(0, 50) == Approx(2.0 / 50)); // a mere damper
    CHECK(limit<SemiImplicitEuler>(0) == INFINITY);
    CHECK(limit<RungeKutta4>(0, 1) == Approx(2.785293563405282));
}

TEST_CASE("damping that is computed explicitly makes the limit smaller, not larger (hard case I6)", "[springs]") {
    CHECK(limit<SemiImplicitEuler>(100, 0) == Approx(0.2));
    CHECK(limit<SemiImplicitEuler>(100, 2) == Approx(0.180998).epsilon(1e-5));
    CHECK(limit<SemiImplicitEuler>(100, 20) == Approx(0.0828427).epsilon(1e-5));
    CHECK(limit<SemiImplicitEuler>(100, 200) == Approx(0.00997512).epsilon(1e-5));
    CHECK(limit<SemiImplicitEuler>(1e4, 2000) == Approx(0.000997512).epsilon(1e-5));
}

TEST_CASE("just below the limit a world stays, just above it explodes: every explicit method, damped and not",
          "[springs]") {
    for_each_type(Types<SemiImplicitEuler, VelocityVerlet, Verlet, RungeKutta4, OdeintRungeKutta4>{}, [&]<class I>() {
        for (const double c : {0.0, 2.0, 20.0, 200.0}) {
            INFO("damping " << c);
            auto grown = [&](double part) {
                World world{I{}, Springs{}};
                const auto body = world.add(position(metres(1.01, 0, 0)), mass(1.0 * kilogram));
                world.add(Spring{metres(0, 0, 0), body, 100.0 * N_per_m, c * N_s_per_m, 1.0 * metre});
                const auto h = part * stable_step(world);
                double most = 0;
                for (int i = 0; i < 4000; ++i) {
                    world.step(h);
                    const double now = std::abs(x(world.position(body)).value() - 1);
                    if (!(now < 1)) return 1e300;              // it has turned over: no small swing any more
                    if (i >= 2000) most = std::max(most, now); // at first even what decays may grow: two equal rates
                }
                return most;
            };
            CHECK(grown(0.99) <= 0.1);
            CHECK(grown(1.01) >= 1);
        }
    });
}

TEST_CASE("the bound holds for networks of any masses and stiffnesses, and is exact for two bodies", "[springs]") {
    World pair{SemiImplicitEuler{}, Springs{}};
    const auto light = pair.add(position(metres(0, 0, 0)), mass(1.0 * kilogram)),
               heavy = pair.add(position(metres(1, 0, 0)), mass(1000.0 * kilogram));
    pair.add(Spring{light, heavy, 1e3 * N_per_m, 7.0 * N_s_per_m});
    CHECK(stiffness_of(pair).largest.value() == Approx(1e3 * (1 + 1e-3)));
    CHECK(stiffness_of(pair).damping.value() == Approx(7 * (1 + 1e-3)));
    CHECK(measured_stiffness(pair).value() == Approx(1e3 * (1 + 1e-3)));

    std::mt19937 random(17);
    auto uniform = [&](double low, double high) {
        return low + (high - low) * (double(random()) / double(random.max()));
    };
    for (int trial = 0; trial < 30; ++trial) {
        World world{SemiImplicitEuler{}, Space<double, 2>{}, Springs{}, Ropes{}};
        std::vector<Handle> bodies;
        const int n = 2 + int(random() % 9);
        for (int i = 0; i < n; ++i)
            bodies.push_back(world.add(position(metres(uniform(-1, 1), uniform(-1, 1))),
                                       mass(std::pow(10.0, uniform(-2, 2)) * kilogram)));
        for (int s = 0; s < 3 * n; ++s) {
            const auto i = random() % bodies.size(), j = random() % bodies.size();
            const auto k = std::pow(10.0, uniform(0, 4)) * N_per_m;
            if (i == j) world.add(Spring{bodies[i], metres(uniform(-1, 1), 0.0), k});
            else if (s % 2 == 0) world.add(Spring{bodies[i], bodies[j], k, {}, uniform(0, 0.2) * metre}); // stretched
            else world.add(Rope{bodies[i], bodies[j], k, {}, uniform(0, 3) * metre});
        }
        // The truth: differences of the accelerations, as a dense matrix in the measure of the masses.
        Eigen::MatrixXd K(2 * n, 2 * n);
        const double e = 1e-7;
        for (int c = 0; c < 2 * n; ++c) {
            auto moved = [&](double by) {
                auto w = world;
                auto at_ = w.position(bodies[std::size_t(c / 2)]).value();
                at_[c % 2] += by;
                w.set_position(bodies[std::size_t(c / 2)], Space<double, 2>::Position::from_value(at_));
                Eigen::VectorXd a(2 * n);
                for (int r = 0; r < n; ++r) a.segment<2>(2 * r) = w.acceleration(bodies[std::size_t(r)]).value();
                return a;
            };
            K.col(c) = -(moved(e) - moved(-e)) / (2 * e);
        }
        for (int r = 0; r < 2 * n; ++r)
            for (int c = 0; c < 2 * n; ++c)
                K(r, c) *= std::sqrt(world.mass(bodies[std::size_t(r / 2)]).value() /
                                     world.mass(bodies[std::size_t(c / 2)]).value());
        const double truth =
            Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(0.5 * (K + K.transpose())).eigenvalues().maxCoeff();
        CHECK(stiffness_of(world).largest.value() >= truth * (1 - 1e-6));
        CHECK(measured_stiffness(world, 20000).value() ==
              Approx(truth).epsilon(0.02)); // power iteration is slow where two are close
        CHECK(measured_stiffness(world).value() <= stiffness_of(world).largest.value() * (1 + 1e-12));
    }
}

TEST_CASE("the bound is that of the masses as they are, whatever was asked before", "[springs]") {
    World world{SemiImplicitEuler{}, Springs{}, Rest{}};
    const auto light = world.add(mass(1.0 * kilogram)), other = world.add(mass(1.0 * kilogram), resting);
    world.add(Spring{light, metres(1, 0, 0), 100.0 * newton_per_metre});
    world.add(Spring{other, metres(5, 0, 0), 100.0 * newton_per_metre});
    const auto largest = [&] { return stiffness_of(world).largest.value(); };
    CHECK(largest() == Approx(100));
    world.set_mass(light, 0.25 * kilogram);
    CHECK(largest() == Approx(400));
    world.set_mass(other, 0.125 * kilogram); // which wakes, and changes places
    CHECK(largest() == Approx(800));
    world.set_mass(light, 0.0625 * kilogram);
    CHECK(largest() == Approx(1600));
}

TEST_CASE("at the limit of a network with springs of every damping nothing grows, with every explicit method",
          "[springs]") {
    for_each_type(Types<SemiImplicitEuler, VelocityVerlet, Verlet, RungeKutta4>{}, [&]<class I>() {
        std::mt19937 random(4);
        auto uniform = [&](double low, double high) {
            return low + (high - low) * (double(random()) / double(random.max()));
        };
        for (int trial = 0; trial < 20; ++trial) {
            World world{I{}, Space<double, 2>{}, Springs{}};
            std::vector<Handle> bodies;
            for (int i = 0; i < 8; ++i) { // on a line, so that it is linear: along it, and small
                bodies.push_back(world.add(position(metres(i + 1, 0)),
                                           velocity(metres_per_second(uniform(-1e-6, 1e-6), 0)),
                                           mass(std::pow(10.0, uniform(-1, 1)) * kilogram)));
                SpringEnd before = metres(0, 0);
                if (i > 0) before = bodies[std::size_t(i) - 1];
                const double k = std::pow(10.0, uniform(1, 3));
                world.add(Spring{before, bodies.back(), k * N_per_m,
                                 (trial % 2 == 0 ? uniform(0, 20) : 0.02 * k) * N_s_per_m});
            }
            const auto h = 0.999 * stable_step(world);
            REQUIRE(h > 0.0 * second);
            double early = 0, late = 0;
            for (int i = 0; i < 6000; ++i) {
                world.step(h);
                double now = 0;
                for (std::size_t b = 0; b < bodies.size(); ++b)
                    now = std::max(now, std::abs(x(world.position(bodies[b])).value() - double(b + 1)));
                (i < 2000 ? early : late) = std::max(i < 2000 ? early : late, now);
            }
            CHECK(late <= 1.5 * early);
        }
    });
}

TEST_CASE("worlds without springs, without masses that move, and bad numbers", "[springs]") {
    World empty{SemiImplicitEuler{}, Springs{}};
    CHECK(stable_step(empty) == INFINITY * second);
    const auto post = empty.add(fixed);
    empty.add(Spring{post, metres(1, 0, 0), 1e9 * N_per_m});
    CHECK(stable_step(empty) == INFINITY * second);
    CHECK(measured_stiffness(empty).value() == 0);
    World none{SemiImplicitEuler{}, Gravity{}};
    CHECK(stable_step(none) == INFINITY * second);
    World explicit_{ExplicitEuler{}, Springs{}};
    const auto body = explicit_.add(mass(1.0 * kilogram));
    const auto spring = explicit_.add(Spring{body, metres(1, 0, 0), 100.0 * N_per_m});
    CHECK(stable_step(explicit_) == 0.0 * second);
    explicit_.set(spring, Spring{body, metres(1, 0, 0), 100.0 * N_per_m, 2.0 * N_s_per_m});
    CHECK(in(stable_step(explicit_), second) == Approx(0.02));
    CHECK_THROWS_WITH(limit<Verlet>(-1), ContainsSubstring("stable_step: stiffness is -1 1/s^2"));
    CHECK_THROWS_WITH(limit<Verlet>(1, NAN), ContainsSubstring("stable_step: damping is nan 1/s"));
}
