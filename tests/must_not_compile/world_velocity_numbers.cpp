// expect: velocity takes one vector of velocities
// SPDX-License-Identifier: BSL-1.0
// Three numbers instead of a vector.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}};
#ifdef ANSATZ_MISTAKE
    world.add(velocity(1, 2, 3));
#else
    world.add(velocity(metres_per_second(1, 2, 3)));
#endif
}
