// SPDX-License-Identifier: BSL-1.0

// Hard cases I2, I5 and I6: exact growth, sharp limits, and what damping does to them.

#include "tests/measured.hpp"
#include "tests/motion/support.hpp"

using namespace motion_tests;

namespace {

/// The largest |x| over `steps` steps of an oscillator with omega h = `z`, from (1 m, 0).
template <class I> double largest(double z, int steps) {
    World world{Space<double, 2>{}, I{}, Oscillator{10.0 / second}};
    const auto body = add_body(world, OnALine{1.0 * metre, 0.0 * metre_per_second});
    double most = 0;
    for (int i = 0; i < steps; ++i) {
        world.step(z / 10 * second);
        most = std::max(most, std::abs(world.position(body).value()[0]));
        if (!(most < 1e300)) return std::numeric_limits<double>::infinity();
    }
    return most;
}

/// The growth of the energy of a spring of 100 N/m with 1 kg over 60 steps of 1/60 s.
template <class S, class I> double growth() {
    World world{S{}, I{}, PointSpring{100.0 * newton_per_metre}};
    const auto body = add_body(world, OnALine{1.0 * metre, 0.0 * metre_per_second});
    run(world, 60, 1.0 / 60);
    const auto s = state(world, body);
    return s[3] * s[3] / 100 + s[0] * s[0];
}

/// |x| and |v| after 20 000 steps of the damped spring, as one number.
double damped_size(double k, double c, double h) {
    World world{Space<double, 2>{}, SemiImplicitEuler{}, Oscillator{std::sqrt(k) / second}, LinearDamping{c / second}};
    const auto body = add_body(world, OnALine{1.0 * metre, 0.0 * metre_per_second});
    for (int i = 0; i < 20000; ++i) {
        world.step(h * second);
        if (!(std::abs(world.position(body).value()[0]) < 1e100)) return std::numeric_limits<double>::infinity();
    }
    const auto s = state(world, body);
    return std::hypot(s[0], s[3] / std::sqrt(k));
}

} // namespace

TEST_CASE("I2 exact growth: explicit and implicit Euler by (1 + omega^2 h^2)^(+-60)", "[motion][I2]") {
    const double factor = std::pow(1 + 100 / 3600.0, 60); // 5.175513
    for_each_type(Types<Space<double, 2>, Space<double, 3>>{}, [&]<class S> {
        const double out = growth<S, ExplicitEuler>(), in = growth<S, ImplicitEuler>();
        INFO("explicit " << out << ", should be " << factor << "; implicit " << in << ", should be " << 1 / factor);
        CHECK(
            test::measured("I2", "error of ExplicitEuler's growth", std::abs(out / factor - 1), test::at_most(1e-12)));
        CHECK(test::measured("I2", "error of ImplicitEuler's decay", std::abs(in * factor - 1), test::at_most(1e-12)));
    });
    for_each_type(Types<Space<float, 2>, Space<float, 3>>{}, [&]<class S> {
        const double out = growth<S, ExplicitEuler>(), in = growth<S, ImplicitEuler>();
        INFO("explicit " << out << ", should be " << factor << "; implicit " << in << ", should be " << 1 / factor);
        CHECK(test::measured("I2", "error of ExplicitEuler's growth in float", std::abs(out / factor - 1),
                             test::at_most(1e-4)));
        CHECK(test::measured("I2", "error of ImplicitEuler's decay in float", std::abs(in * factor - 1),
                             test::at_most(1e-4)));
    });
}

TEST_CASE("I5 sharp limit: omega h = 2 for semi-implicit Euler and both Verlets", "[motion][I5]") {
    for_each_type(Types<SemiImplicitEuler, VelocityVerlet, Verlet>{}, []<class I> {
        const double below = largest<I>(1.999, 2000), above = largest<I>(2.001, 2000);
        INFO("largest |x| at omega h = 1.999: " << below << " (theory: at most 31.6); at 2.001: " << above
                                                << " (it should diverge)");
        CHECK(below <= 100); // measured 24.1
        CHECK(above > 1e9);
    });
}

TEST_CASE("I5 sharp limit: 2 sqrt(2) for Runge-Kutta, none for implicit Euler, zero for explicit", "[motion][I5]") {
    for_each_type(Types<RungeKutta4, OdeintRungeKutta4>{}, []<class I> {
        // |1 + iz - z^2/2 - iz^3/6 + z^4/24| = 1 at z = 2 sqrt 2 = 2.828427
        const double below = largest<I>(2.828, 100000), above = largest<I>(2.829, 100000);
        INFO("largest |x| at omega h = 2.828: " << below << ", at 2.829: " << above << " (it should diverge)");
        CHECK(below <= 10);
        CHECK(above > 1e9);
    });
    for (const double z : {0.1, 1.0, 10.0, 1e3, 1e6}) CHECK(largest<ImplicitEuler>(z, 1000) <= 1);
    CHECK(largest<ExplicitEuler>(0.2, 2000) > 1e9); // 1.04^1000
}

TEST_CASE("I6 explicit damping shrinks the limit of semi-implicit Euler", "[motion][I6]") {
    struct Row {
        double k, c, limit;
    };
    for (const auto& [k, c, limit] : {Row{100, 0, 0.2}, Row{100, 2, 0.180998}, Row{100, 20, 0.0828427},
                                      Row{100, 200, 0.00997512}, Row{1e4, 2000, 0.000997512}}) {
        const double formula = (std::sqrt(c * c + 4 * k) - c) / k;
        CHECK(std::abs(formula / limit - 1) <= 1e-5);
        const double below = damped_size(k, c, 0.99 * formula), above = damped_size(k, c, 1.01 * formula);
        INFO("k = " << k << ", c = " << c << ": limit h = " << formula << " s; size at 0.99 of it " << below
                    << ", at 1.01 of it " << above);
        if (c > 0) CHECK(below < 1e-3);
        else CHECK(below < 100); // nothing damps it: bounded is all
        CHECK(above > 1e50);
    }
}
