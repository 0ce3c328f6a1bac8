// SPDX-License-Identifier: BSL-1.0

// Hard case I13: Kepler's ellipse of eccentricity 0.6, a hundred times round with 1000 steps a period.

#include "tests/measured.hpp"
#include "tests/motion/support.hpp"

#include <numbers>

using namespace motion_tests;

namespace {

constexpr double e = 0.6, period = 2 * std::numbers::pi;

struct Drift {
    double energy_first = 0, energy_all = 0,
           energy_last = 0;      // max |dE / E0| in the first, in all, in the last of the periods
    double angular_momentum = 0; // max |dL / L0| in all
};

template <class S, class I> Drift drift(int periods, int steps_a_period) {
    World world{S{}, I{}, CentralGravity{}};
    const auto body = add_body(world, kepler(e));
    // Measured in double, so that what is seen is the state's error and not the measurement's.
    auto E = [&] {
        const auto s = state(world, body);
        return 0.5 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]) - 1 / std::sqrt(s[0] * s[0] + s[1] * s[1] + s[2] * s[2]);
    };
    auto L = [&] {
        const auto s = state(world, body);
        return s[0] * s[4] - s[1] * s[3];
    };
    const double E0 = E(), L0 = L();
    Drift d;
    for (int p = 0; p < periods; ++p) {
        d.energy_last = 0;
        for (int i = 0; i < steps_a_period; ++i) {
            world.step(period / steps_a_period * second);
            d.energy_last = std::max(d.energy_last, std::abs(E() / E0 - 1));
            d.angular_momentum = std::max(d.angular_momentum, std::abs(L() / L0 - 1));
        }
        if (p == 0) d.energy_first = d.energy_last;
        d.energy_all = std::max(d.energy_all, d.energy_last);
    }
    return d;
}

} // namespace

TEST_CASE("I13 Kepler: velocity Verlet's energy swings and does not drift", "[motion][I13]") {
    for_each_type(Types<Space<double, 2>, Space<double, 3>>{}, []<class S> {
        const auto d = drift<S, VelocityVerlet>(100, 1000);
        INFO("max |dE/E| in the first period " << d.energy_first << ", in a hundred " << d.energy_all << ", |dL/L| "
                                               << d.angular_momentum);
        CHECK(
            test::measured("I13", "VelocityVerlet: largest |dE/E| in one period", d.energy_first, test::at_most(4e-4)));
        CHECK(test::measured("I13", "VelocityVerlet: largest |dE/E| in a hundred periods", d.energy_all,
                             test::at_most(4e-4)));
        CHECK(test::measured("I13", "VelocityVerlet: a hundred periods by one", d.energy_all / d.energy_first,
                             test::at_most(1.02)));
        // A central kick along x keeps L to rounding.
        CHECK(test::measured("I13", "VelocityVerlet: largest |dL/L|", d.angular_momentum, test::at_most(1e-12)));
    });
}

TEST_CASE("I13 Kepler: semi-implicit Euler's too, at first order", "[motion][I13]") {
    const auto d = drift<Space<double, 2>, SemiImplicitEuler>(100, 1000);
    INFO("max |dE/E| " << d.energy_all << ", |dL/L| " << d.angular_momentum);
    CHECK(d.energy_all <= 2.5e-2); // measured 1.78e-2
    CHECK(d.energy_all <= 1.05 * d.energy_first);
    CHECK(d.angular_momentum <= 1e-12);
}

TEST_CASE("I13 Kepler: position Verlet is the same scheme, with coarser roundings", "[motion][I13]") {
    const auto d = drift<Space<double, 2>, Verlet>(100, 1000);
    INFO("max |dE/E| " << d.energy_all << ", |dL/L| " << d.angular_momentum);
    CHECK(d.energy_all <= 4e-4);
    CHECK(d.energy_all <= 1.02 * d.energy_first);
    // Its velocity is (x - x_before) / h: a rounding of x by 2^-53 * 1.6 m is a kick of that / h = 3e-14 m/s, and 1e5
    // random ones add up to 300 times that.
    CHECK(d.angular_momentum <= 1e-11);
}

TEST_CASE("I13 Kepler: float", "[motion][I13]") {
    const auto d = drift<Space<float, 2>, VelocityVerlet>(100, 1000);
    INFO("max |dE/E| " << d.energy_all << ", |dL/L| " << d.angular_momentum);
    CHECK(d.energy_all <= 6e-4);       // measured 4.3e-4
    CHECK(d.angular_momentum <= 1e-4); // measured 4.8e-5
}

TEST_CASE("I13 Kepler: explicit Euler unbinds", "[motion][I13]") {
    const auto d = drift<Space<double, 2>, ExplicitEuler>(100, 1000);
    INFO("explicit Euler: max |dE/E| " << d.energy_all);
    CHECK(d.energy_all > 0.9); // negative control: measured 0.99
}

TEST_CASE("I13 Kepler: half the step divides the swing of the energy by four", "[motion][I13]") {
    const auto coarse = drift<Space<double, 2>, VelocityVerlet>(3, 1000),
               fine = drift<Space<double, 2>, VelocityVerlet>(3, 2000);
    INFO("max |dE/E| " << coarse.energy_all << " and with half the step " << fine.energy_all);
    CHECK(std::abs(slope(coarse.energy_all, fine.energy_all) - 2) <= 0.05);
}
