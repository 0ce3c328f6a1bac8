// expect: position and velocity are changed by set_position and set_velocity, because the integrator owns what they mean
// SPDX-License-Identifier: BSL-1.0
// A velocity is not just a column.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, Gravity{}, Drag{}};
    auto ball = world.add(position(metres(0, 10, 0)));
#ifdef ANSATZ_MISTAKE
    world.write<Velocity>(ball, metres_per_second(1, 0, 0));
#else
    world.set_velocity(ball, metres_per_second(1, 0, 0));
#endif
}
