// expect: velocity takes a vector of velocities; write e.g. velocity(metres_per_second(1, 0, 0))
// SPDX-License-Identifier: BSL-1.0
// A position given as a velocity.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, Gravity{}, Drag{}};
#ifdef ANSATZ_MISTAKE
    world.add(velocity(metres(0, 10, 0)));
#else
    world.add(velocity(metres_per_second(0, 10, 0)));
#endif
}
