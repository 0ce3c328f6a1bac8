// expect: an integrator that derives velocity from positions loses digits of them at any distance, so that there is no radius within which it does not; take one that keeps them, e.g. VelocityVerlet
// SPDX-License-Identifier: BSL-1.0
// A world radius is declared where there is none.

#include <ansatz/motion.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{Verlet{}, WorldRadius{}};
#else
    World world{VelocityVerlet{}, WorldRadius{}};
#endif
    return world.status().ok() ? 0 : 1;
}
