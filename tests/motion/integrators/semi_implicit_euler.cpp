// SPDX-License-Identifier: BSL-1.0
#include <ansatz/motion/integrators/semi_implicit_euler.hpp>

#include "tests/motion/integrators/closed_form.hpp"

using namespace motion_tests;

TEST_CASE("semi-implicit Euler moves with the new velocity, as its matrix says", "[motion][semi_implicit_euler]") {
    check_closed_form<SemiImplicitEuler>([](long double w, long double h) {
        return Amplification{1 - w * w * h * h, h, -w * w * h, 1};
    });
}

TEST_CASE("semi-implicit Euler asks the forces once a step", "[motion][semi_implicit_euler]") {
    CHECK(evaluations_of_a_step<SemiImplicitEuler>() == 1);
}

TEST_CASE("I3 semi-implicit Euler keeps its shadow Hamiltonian over a million steps",
          "[motion][semi_implicit_euler][I3]") {
    // H~ = v^2/2 + w^2 x^2/2 - h w^2 x v / 2 is kept exactly by "velocity first"; by "position first" the sign is the
    // other one, and explicit Euler keeps neither: this one test tells the three apart.
    const double w = 10, h = 1.0 / 60;
    World world{Space<double, 2>{}, SemiImplicitEuler{}, Oscillator{w / second}};
    const auto body = add_body(world, OnALine{1.0 * metre, 3.0 * metre_per_second});
    auto shadow = [&](double sign) {
        const auto s = state(world, body);
        return 0.5 * s[3] * s[3] + 0.5 * w * w * s[0] * s[0] + sign * 0.5 * h * w * w * s[0] * s[3];
    };
    const double kept = shadow(-1), other = shadow(+1);
    double drift = 0, drift_of_the_other = 0;
    for (int i = 0; i < 1'000'000; ++i) {
        world.step(h * second);
        drift = std::max(drift, std::abs(shadow(-1) / kept - 1));
        drift_of_the_other = std::max(drift_of_the_other, std::abs(shadow(+1) / other - 1));
    }
    INFO("largest drift " << drift << "; with the wrong sign " << drift_of_the_other);
    CHECK(drift <= 1e-11);
    CHECK(drift_of_the_other > 0.1); // negative control
}
