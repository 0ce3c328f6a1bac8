// SPDX-License-Identifier: BSL-1.0
#include <ansatz/motion/integrators/velocity_verlet.hpp>

#include "tests/motion/integrators/closed_form.hpp"

using namespace motion_tests;

TEST_CASE("velocity Verlet takes the mean of both accelerations, as its matrix says", "[motion][velocity_verlet]") {
    check_closed_form<VelocityVerlet>([](long double w, long double h) {
        const long double q = w * w * h * h;
        return Amplification{1 - q / 2, h, -w * w * h * (1 - q / 4), 1 - q / 2};
    });
}

TEST_CASE("velocity Verlet asks the forces twice a step", "[motion][velocity_verlet]") {
    CHECK(evaluations_of_a_step<VelocityVerlet>() == 2);
}

TEST_CASE("I4 velocity Verlet keeps its invariant over a million steps", "[motion][velocity_verlet][I4]") {
    const double w = 10, h = 1.0 / 60;
    World world{Space<double, 2>{}, VelocityVerlet{}, Oscillator{w / second}};
    const auto body = add_body(world, OnALine{1.0 * metre, 3.0 * metre_per_second});
    auto invariant = [&](double share) {
        const auto s = state(world, body);
        return 0.5 * s[3] * s[3] + 0.5 * w * w * s[0] * s[0] * (1 - share * h * h * w * w / 4);
    };
    const double kept = invariant(1), energy = invariant(0);
    double drift = 0, drift_of_the_energy = 0;
    for (int i = 0; i < 1'000'000; ++i) {
        world.step(h * second);
        drift = std::max(drift, std::abs(invariant(1) / kept - 1));
        drift_of_the_energy = std::max(drift_of_the_energy, std::abs(invariant(0) / energy - 1));
    }
    INFO("largest drift " << drift << "; of the true energy " << drift_of_the_energy);
    CHECK(drift <= 1e-11);
    CHECK(drift_of_the_energy > 1e-3); // it swings by (w h)^2 / 4: negative control
}
