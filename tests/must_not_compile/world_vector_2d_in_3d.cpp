// expect: a vector has another dimension than its world
// SPDX-License-Identifier: BSL-1.0
// A vector of the plane in a world of three dimensions.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, Gravity{}, Drag{}};
    auto ball = world.add(position(metres(0, 10, 0)));
#ifdef ANSATZ_MISTAKE
    world.set_velocity(ball, metres_per_second(1, 0));
#else
    world.set_velocity(ball, metres_per_second(1, 0, 0));
#endif
}
