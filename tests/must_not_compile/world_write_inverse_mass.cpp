// expect: a mass is changed by set_mass
// SPDX-License-Identifier: BSL-1.0
// An inverse mass is not just a column: it must not be negative.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, AppliedForces{}};
    auto ball = world.add(mass(2.0 * kilogram));
#ifdef ANSATZ_MISTAKE
    world.write<InverseMass>(ball, -1.0 / kilogram);
#else
    world.set_mass(ball, 2.0 * kilogram);
#endif
}
