// expect: a fixed or moving body has infinite mass; leave mass(...) out
// SPDX-License-Identifier: BSL-1.0
// Fixed, with a mass.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, AppliedForces{}};
#ifdef ANSATZ_MISTAKE
    world.add(fixed, mass(2.0 * kilogram));
#else
    world.add(fixed);
#endif
}
