// SPDX-License-Identifier: BSL-1.0
#include "tests/motion/integrators/closed_form.hpp"

using namespace motion_tests;

TEST_CASE("Runge-Kutta 4 is the Taylor series to the fourth power of the step", "[motion][runge_kutta4]") {
    auto matrix = [](long double w, long double h) {
        const long double q = w * w * h * h, cosine = 1 - q / 2 + q * q / 24, sine = 1 - q / 6;
        return Amplification{cosine, h * sine, -w * w * h * sine, cosine};
    };
    check_closed_form<RungeKutta4>(matrix);
    check_closed_form<OdeintRungeKutta4>(matrix); // and so is Boost's
}

TEST_CASE("Runge-Kutta 4 asks the forces four times a step", "[motion][runge_kutta4]") {
    CHECK(evaluations_of_a_step<RungeKutta4>() == 4);
}

namespace {
/// a = t^3 along x, as a number.
struct CubedTime {
    using role = roles::Force;
    using reads = Columns<Clock>;
    template <class S> struct In {
        explicit In(const CubedTime&) {}
        typename S::Acceleration acceleration(const auto& context) const {
            auto a = S::template zero_vector<unit::Acceleration>().value();
            const double t = context.time().value();
            a[0] = t * t * t;
            return S::Acceleration::from_value(a);
        }
    };
};
} // namespace

TEST_CASE("Runge-Kutta 4 asks a force of time at the beginning, twice in the middle, and at the end of the step",
          "[motion][runge_kutta4]") {
    // Simpson's rule is exact for t^3 in the velocity: v(T) = T^4 / 4 to rounding, whatever the step.
    World world{Space<double, 2>{}, RungeKutta4{}, CubedTime{}};
    const auto body = world.add();
    run(world, 4, 0.5);
    CHECK(std::abs(world.velocity(body).value()[0] - 4) <= 1e-14);
}
