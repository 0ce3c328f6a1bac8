// expect: this world stores no mass, because none of its policies needs it
// SPDX-License-Identifier: BSL-1.0
// An impulse needs a mass.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, Gravity{}, Drag{}};
    auto ball = world.add(position(metres(0, 10, 0)));
#ifdef ANSATZ_MISTAKE
    world.apply_impulse(ball, newton_seconds(1, 0, 0));
#else
    world.set_velocity(ball, metres_per_second(1, 0, 0));
#endif
}
