// expect: beside a spring or a rope where it breaks
// SPDX-License-Identifier: BSL-1.0
// A force beside a spring, without saying that it breaks there.

#include <ansatz/springs/springs.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, Springs<Breaking>{}};
    const auto ball = world.add(mass(2.0 * kilogram));
#ifdef ANSATZ_MISTAKE
    world.add(Spring{ball, metres(0, 1, 0), 100.0 * newton_per_metre}, 50.0 * newton);
#else
    world.add(Spring{ball, metres(0, 1, 0), 100.0 * newton_per_metre}, breaks_at(50.0 * newton));
#endif
}
