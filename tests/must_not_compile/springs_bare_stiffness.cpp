// expect: a bare number where a quantity belongs
// SPDX-License-Identifier: BSL-1.0
// A stiffness without its unit.

#include <ansatz/springs/springs.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, Springs{}};
    const auto ball = world.add(mass(2.0 * kilogram));
#ifdef ANSATZ_MISTAKE
    world.add(Spring{ball, metres(0, 1, 0), 100.0});
#else
    world.add(Spring{ball, metres(0, 1, 0), 100.0 * newton_per_metre});
#endif
}
