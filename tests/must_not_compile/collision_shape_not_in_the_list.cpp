// expect: add: a shape that this world's narrowphase does not know; name it there
// SPDX-License-Identifier: BSL-1.0
// A box, where only spheres and planes are tested.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, BoundingBoxes{}, Narrowphase<Sphere, Plane>{}, Impulse<>{}};
#ifdef ANSATZ_MISTAKE
    world.add(Box{metres(1, 1, 1)}, mass(1.0 * kilogram));
#else
    world.add(Plane::ground(), fixed);
#endif
}
