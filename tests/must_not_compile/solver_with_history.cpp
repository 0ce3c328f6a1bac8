// expect: a solver corrects velocities with positions, and this integrator keeps a history of positions instead of a velocity; take SemiImplicitEuler or VelocityVerlet
// SPDX-License-Identifier: BSL-1.0
// Verlet has no velocity that a solver could correct.

#include <ansatz/soft_bodies/xpbd.hpp>
#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{Verlet{}, Springs<>{}, Xpbd{}};
#else
    World world{SemiImplicitEuler{}, Springs<>{}, Xpbd{}};
#endif
    world.step(0.1 * second);
}
