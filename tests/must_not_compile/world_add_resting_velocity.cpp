// expect: a resting body has no velocity
// SPDX-License-Identifier: BSL-1.0
// Asleep and moving.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, Rest{}};
#ifdef ANSATZ_MISTAKE
    world.add(resting, velocity(metres_per_second(1, 0, 0)));
#else
    world.add(resting);
#endif
}
