// expect: World has more than one integrator; keep exactly one
// SPDX-License-Identifier: BSL-1.0
// The same integrator twice is two.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{Verlet{}, Gravity{}, Verlet{}};
#else
    World world{Verlet{}, Gravity{}};
#endif
    world.step(0.1 * second);
}
