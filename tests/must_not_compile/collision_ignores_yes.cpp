// expect: layers are the bits of a whole number: write e.g. member_of(1 << 3)
// SPDX-License-Identifier: BSL-1.0
// Which layers a body ignores, not whether.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, BoundingBoxes{}, Layers{}, Narrowphase<Sphere>{}, Impulse<>{}};
#ifdef ANSATZ_MISTAKE
    world.add(Sphere{0.5 * metre}, mass(1.0 * kilogram), ignores(true));
#else
    world.add(Sphere{0.5 * metre}, mass(1.0 * kilogram), ignores(1u << 23));
#endif
}
