// expect: this world's policies need the mass of a body; give it, e.g. mass(2.0 * kilogram), or say fixed
// SPDX-License-Identifier: BSL-1.0
// A force acts and there is no mass.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, AppliedForces{}};
#ifdef ANSATZ_MISTAKE
    world.add(position(metres(0, 10, 0)));
#else
    world.add(position(metres(0, 10, 0)), mass(2.0 * kilogram));
#endif
}
