// expect: World has water and no Gravity; the weight of water is that of the world, so add Gravity{}
// SPDX-License-Identifier: BSL-1.0
// Water in a world where nothing weighs anything.

#include <ansatz/water.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{SemiImplicitEuler{}, Pools<Pipes>{}};
#else
    World world{SemiImplicitEuler{}, Gravity{}, Pools<Pipes>{}};
#endif
    world.step(0.01 * second);
}
