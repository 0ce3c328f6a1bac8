// expect: the options of Springs and Ropes are Undamped and Breaking
// SPDX-License-Identifier: BSL-1.0
// An option that springs do not have.

#include <ansatz/springs/springs.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{SemiImplicitEuler{}, Springs<Gravity>{}};
#else
    World world{SemiImplicitEuler{}, Springs<Undamped>{}};
#endif
    world.add(mass(2.0 * kilogram));
}
