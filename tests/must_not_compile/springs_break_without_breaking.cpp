// expect: the springs of this world do not break; write Springs<Breaking>{}
// SPDX-License-Identifier: BSL-1.0
// A limit for a spring that cannot break.

#include <ansatz/springs/springs.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{SemiImplicitEuler{}, Springs{}};
#else
    World world{SemiImplicitEuler{}, Springs<Breaking>{}};
#endif
    const auto ball = world.add(mass(2.0 * kilogram));
    world.add(Spring{ball, metres(0, 1, 0), 100.0 * newton_per_metre}, breaks_at(50.0 * newton));
}
