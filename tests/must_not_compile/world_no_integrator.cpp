// expect: World has no integrator; add one, e.g. SemiImplicitEuler
// SPDX-License-Identifier: BSL-1.0
// A world that nothing advances.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{Gravity{}};
#else
    World world{SemiImplicitEuler{}, Gravity{}};
#endif
    world.step(0.1 * second);
}
