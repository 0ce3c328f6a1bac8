// SPDX-License-Identifier: BSL-1.0
// No effect, no difference: a world with a policy whose coefficient is zero is bit-identical to the world without it
// (rows N), by every integrator.

#include <ansatz/motion/integration.hpp>

#include "tests/catch.hpp"
#include "tests/world/same_motion.hpp"

using namespace ansatz;
using namespace ansatz::test;

TEMPLATE_TEST_CASE("a policy with coefficient zero is as good as none, to the bit", "[world][N1]", ANSATZ_INTEGRATORS) {
    using I = TestType;
    World plain{I{}, spring, Gravity{}};
    CHECK(same_motion(plain, World{I{}, spring, Gravity{}, Drag{0.0 / second}, FrameDrag{1.0},
                                   StopBelow{0.0 * metre_per_second}, QuadraticDrag{0.0 * kilogram_per_metre},
                                   AppliedForces{}, Interpolation{}, Keep<Heat>{}}));
}

TEST_CASE("one effect at a time, in float and in the plane, is as good as none, to the bit", "[world][N1]") {
    using I = Verlet; // whose history an effect could disturb although it changes no velocity
    using S = Space<float, 2>;
    World plain{S{}, I{}, spring};
    CHECK(same_motion(plain, World{S{}, I{}, spring, Drag{0.0 / second}}));
    CHECK(same_motion(plain, World{S{}, I{}, spring, FrameDrag{1.0}}));
    CHECK(same_motion(plain, World{S{}, I{}, spring, StopBelow{0.0 * metre_per_second}}));
    CHECK(same_motion(plain, World{S{}, I{}, spring, QuadraticDrag{0.0 * kilogram_per_metre}}));
    CHECK(same_motion(plain, World{S{}, I{}, spring, Rest{}})); // no body rests while a spring pulls
    CHECK(same_motion(plain, World{S{}, I{}, spring, Gravity{metres_per_second_squared(0, 0, 0)}}));
}

TEST_CASE("the comparison above would see the smallest drag", "[world][N1]") {
    const World plain{Verlet{}, spring, Gravity{}};
    CHECK_FALSE(same_motion(plain, World{Verlet{}, spring, Gravity{}, Drag{1e-12 / second}}));
    CHECK_FALSE(same_motion(plain, World{Verlet{}, spring, Gravity{}, FrameDrag{1 - 1e-13}}));
    CHECK_FALSE(same_motion(plain, World{Verlet{}, spring, Gravity{}, QuadraticDrag{1e-12 * kilogram_per_metre}}));
}
