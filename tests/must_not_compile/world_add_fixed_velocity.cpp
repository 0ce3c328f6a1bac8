// expect: a fixed body has no velocity; a platform that moves is added as `moving`
// SPDX-License-Identifier: BSL-1.0
// Fixed, with a velocity.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, Gravity{}, Drag{}};
#ifdef ANSATZ_MISTAKE
    world.add(fixed, velocity(metres_per_second(1, 0, 0)));
#else
    world.add(moving, velocity(metres_per_second(1, 0, 0)));
#endif
}
