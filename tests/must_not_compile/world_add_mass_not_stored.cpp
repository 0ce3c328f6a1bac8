// expect: this world stores no mass, because none of its policies needs it
// SPDX-License-Identifier: BSL-1.0
// Gravity accelerates every mass alike.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, Gravity{}, Drag{}};
#ifdef ANSATZ_MISTAKE
    world.add(mass(2.0 * kilogram));
#else
    world.add();
#endif
}
