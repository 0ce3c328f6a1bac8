// expect: no member named
// SPDX-License-Identifier: BSL-1.0
// A force from outside that nothing would collect: the member comes with the policy AppliedForces.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{SemiImplicitEuler{}, Attraction{}};
#else
    World world{SemiImplicitEuler{}, Attraction{}, AppliedForces{}};
#endif
    world.apply_force(world.add(mass(2.0 * kilogram)), newtons(1, 0, 0));
}
