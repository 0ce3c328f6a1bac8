// expect: mass takes a mass; write e.g. mass(2.0 * kilogram)
// SPDX-License-Identifier: BSL-1.0
// A bare number for a mass.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, AppliedForces{}};
#ifdef ANSATZ_MISTAKE
    world.add(mass(2.0));
#else
    world.add(mass(2.0 * kilogram));
#endif
}
