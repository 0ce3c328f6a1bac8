// expect: a mass is given by mass(...)
// SPDX-License-Identifier: BSL-1.0
// An inverse mass is not just a column: it must not be negative.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, AppliedForces{}};
#ifdef ANSATZ_MISTAKE
    world.add(with<InverseMass>(-1.0 / kilogram));
#else
    world.add(mass(2.0 * kilogram));
#endif
}
