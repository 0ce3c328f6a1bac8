// SPDX-License-Identifier: BSL-1.0
#include "tests/motion/integrators/closed_form.hpp"

using namespace motion_tests;

TEST_CASE("explicit Euler moves with the old velocity, as its matrix says", "[motion][explicit_euler]") {
    check_closed_form<ExplicitEuler>([](long double w, long double h) { return Amplification{1, h, -w * w * h, 1}; });
}

TEST_CASE("explicit Euler asks the forces once a step", "[motion][explicit_euler]") {
    CHECK(evaluations_of_a_step<ExplicitEuler>() == 1);
}
