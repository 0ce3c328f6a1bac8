// expect: this world has no filter that reads layers; add Layers{} to its policies
// SPDX-License-Identifier: BSL-1.0
// Layers, where no filter reads them.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, BoundingBoxes{}, Narrowphase<Sphere>{}, Impulse<>{}};
#ifdef ANSATZ_MISTAKE
    world.add(Sphere{0.5 * metre}, mass(1.0 * kilogram), member_of(1 << 3));
#else
    world.add(Sphere{0.5 * metre}, mass(1.0 * kilogram));
#endif
}
