// expect: this world stores no mass, because none of its policies needs it
// SPDX-License-Identifier: BSL-1.0
// Asking for a mass that is not stored.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, Gravity{}, Drag{}};
    auto ball = world.add(position(metres(0, 10, 0)));
#ifdef ANSATZ_MISTAKE
    (void)world.mass(ball);
#else
    (void)world.position(ball);
#endif
}
