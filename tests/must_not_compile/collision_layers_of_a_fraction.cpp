// expect: layers are the bits of a whole number: write e.g. member_of(1 << 3)
// SPDX-License-Identifier: BSL-1.0
// A layer is a bit.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, BoundingBoxes{}, Layers{}, Narrowphase<Sphere>{}, Impulse<>{}};
#ifdef ANSATZ_MISTAKE
    world.add(Sphere{0.5 * metre}, mass(1.0 * kilogram), member_of(3.5));
#else
    world.add(Sphere{0.5 * metre}, mass(1.0 * kilogram), member_of(1 << 3));
#endif
}
