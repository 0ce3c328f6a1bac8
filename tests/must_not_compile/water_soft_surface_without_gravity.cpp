// expect: a soft surface is held up by the weight of water, which is that of the world: add_soft_surface needs a world with Gravity{}
// SPDX-License-Identifier: BSL-1.0
// A surface of water where water has no weight.

#include <ansatz/springs.hpp>
#include <ansatz/water.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{SemiImplicitEuler{}, Springs{}};
#else
    World world{SemiImplicitEuler{}, Springs{}, Gravity{}};
#endif
    add_soft_surface(world, {.grid = ColumnGrid(3, 3, 1.0 * metre), .mass_per_area = 50.0 * kilogram / square_metre});
    world.step(0.01 * second);
}
