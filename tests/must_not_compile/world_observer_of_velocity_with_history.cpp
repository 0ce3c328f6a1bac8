// expect: an observer reads Velocity, but this integrator keeps the history of positions
// SPDX-License-Identifier: BSL-1.0
// Position Verlet has no velocity that could be read within a step.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{Verlet{}, Gravity{}, Keep<Velocity>{}};
#else
    World world{VelocityVerlet{}, Gravity{}, Keep<Velocity>{}};
#endif
    world.step(0.1 * second);
}
