// expect: FixedStep::advance takes the time of a frame
// SPDX-License-Identifier: BSL-1.0
// Seconds without their unit.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}};
    FixedStep clock{1.0 / 60 * second};
#ifdef ANSATZ_MISTAKE
    clock.advance(world, 0.016);
#else
    clock.advance(world, 0.016 * second);
#endif
}
