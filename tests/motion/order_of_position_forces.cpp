// SPDX-License-Identifier: BSL-1.0

// Hard case I16, order per force class: forces of position, and the neighbours of I1: another mass, stiffness, axis and
// centre, and a force that is not linear.

#include "tests/motion/force_classes.hpp"

using namespace motion_tests;

TEST_CASE("I16 order per force class: a spring of another mass, axis and centre", "[motion][I16]") {
    check_order_of_all_integrators<SpringProblem>();
}

TEST_CASE("I16 order per force class: Kepler, not linear", "[motion][I16]") {
    check_order_of_all_integrators<KeplerProblem>();
}
