// SPDX-License-Identifier: BSL-1.0

// Hard case I16, order per force class: quadratic drag, and a force of time, which each stage must see at its own time.

#include "tests/motion/force_classes.hpp"

using namespace motion_tests;

TEST_CASE("I16 order per force class: quadratic drag (a force, with mass)", "[motion][I16][I9]") {
    check_order_of_all_integrators<FallProblem>();
}

TEST_CASE("I16 order per force class: forcing, a force of time", "[motion][I16]") {
    check_order_of_all_integrators<DrivenProblem>();
}
