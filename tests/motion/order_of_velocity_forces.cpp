// SPDX-License-Identifier: BSL-1.0

// Hard case I16, order per force class: forces of velocity. A velocity Verlet that evaluates them with a velocity of
// the step before, and a position Verlet that takes the mean velocity of the last step for the present one, fall to
// order 1.

#include "tests/motion/force_classes.hpp"

using namespace motion_tests;

TEST_CASE("I16 order per force class: linear damping", "[motion][I16]") {
    check_order_of_all_integrators<DampedProblem>();
}

TEST_CASE("I16 order per force class: turning axes (Coriolis)", "[motion][I16]") {
    check_order_of_all_integrators<TurningProblem>();
}
