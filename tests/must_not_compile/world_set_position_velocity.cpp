// expect: a vector quantity of another kind belongs here
// SPDX-License-Identifier: BSL-1.0
// A velocity for a position.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, Gravity{}, Drag{}};
    auto ball = world.add(position(metres(0, 10, 0)));
#ifdef ANSATZ_MISTAKE
    world.set_position(ball, metres_per_second(1, 0, 0));
#else
    world.set_position(ball, metres(1, 0, 0));
#endif
}
