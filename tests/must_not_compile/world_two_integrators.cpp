// expect: World has more than one integrator; keep exactly one
// SPDX-License-Identifier: BSL-1.0
// Two integrators: which one would it be?

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{SemiImplicitEuler{}, Gravity{}, Verlet{}};
#else
    World world{SemiImplicitEuler{}, Gravity{}};
#endif
    world.step(0.1 * second);
}
