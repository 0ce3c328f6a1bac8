// expect: Ansatz: a mass belongs here; multiply the number with its unit, e.g. 2.0 * kilogram
// at most: 1 error
// SPDX-License-Identifier: BSL-1.0
// A bare number for the mass of a body.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, AppliedForces{}};
    const auto ball = world.add(mass(1.0 * kilogram));
#ifdef ANSATZ_MISTAKE
    world.set_mass(ball, 2.0);
#else
    world.set_mass(ball, 2.0 * kilogram);
#endif
}
