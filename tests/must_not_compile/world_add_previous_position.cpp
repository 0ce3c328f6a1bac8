// expect: the integrator makes the history of a body from its velocity
// SPDX-License-Identifier: BSL-1.0
// History is not given but follows from the velocity.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{Verlet{}};
#ifdef ANSATZ_MISTAKE
    world.add(with<PreviousPosition>(metres(1, 0, 0)));
#else
    world.add(velocity(metres_per_second(1, 0, 0)));
#endif
}
