// expect: an end of a spring is the handle of a body, or a point
// SPDX-License-Identifier: BSL-1.0
// A velocity where a point belongs.

#include <ansatz/springs/springs.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, Springs{}};
    const auto ball = world.add(mass(2.0 * kilogram));
#ifdef ANSATZ_MISTAKE
    world.add(Spring{ball, metres_per_second(0, 1, 0), 100.0 * newton_per_metre});
#else
    world.add(Spring{ball, metres(0, 1, 0), 100.0 * newton_per_metre});
#endif
}
