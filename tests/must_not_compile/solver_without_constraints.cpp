// expect: World has a solver and nothing that it could hold; add Springs or Ropes
// SPDX-License-Identifier: BSL-1.0
// A force of attraction gives no constraints: it stays a force.

#include <ansatz/soft_bodies/xpbd.hpp>
#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{SemiImplicitEuler{}, Attraction{}, Xpbd{}};
#else
    World world{SemiImplicitEuler{}, Attraction{}, Springs<>{}, Xpbd{}};
#endif
    world.step(0.1 * second);
}
