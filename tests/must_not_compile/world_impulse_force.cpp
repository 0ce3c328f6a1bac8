// expect: a vector quantity of another kind belongs here
// SPDX-License-Identifier: BSL-1.0
// A force is not an impulse.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, AppliedForces{}};
    auto ball = world.add(mass(2.0 * kilogram));
#ifdef ANSATZ_MISTAKE
    world.apply_impulse(ball, newtons(1, 0, 0));
#else
    world.apply_impulse(ball, newton_seconds(1, 0, 0));
#endif
}
