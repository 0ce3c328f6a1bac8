// SPDX-License-Identifier: BSL-1.0

// Hard case I12: steps of h, 2h, h, 2h ... Verlet without its correction does not converge at all then.

#include "tests/motion/force_classes.hpp"

using namespace motion_tests;

namespace {

/// The notes' formula to the letter, whatever the step: the negative control.
struct UncorrectedVerlet : Verlet {
    using role = roles::Integrator;
    using Verlet::advance;
    [[gnu::always_inline]] static void advance(Stage<1>, auto& x, auto& previous, auto&, const auto& a,
                                               const auto& dt) {
        const auto next = x + (x - previous) + a * dt * dt;
        previous = x;
        x = next;
    }
};

} // namespace

TEST_CASE("I12 varying step: h and 2h in turns, force of position", "[motion][I12]") {
    check_order_with_varying_step<SpringProblem>();
}

TEST_CASE("I12 varying step: h and 2h in turns, forces of position, velocity and time", "[motion][I12]") {
    check_order_with_varying_step<DampedDrivenProblem>();
}

TEST_CASE("I12 varying step: without its correction Verlet does not converge", "[motion][I12]") {
    const double coarse = error_of<SpringProblem, UncorrectedVerlet, true>(800),
                 fine = error_of<SpringProblem, UncorrectedVerlet, true>(3200);
    INFO("a negative control: errors " << coarse << " and " << fine << " should not fall");
    CHECK(fine > 0.5 * coarse);
    CHECK(fine > 0.1);
}
