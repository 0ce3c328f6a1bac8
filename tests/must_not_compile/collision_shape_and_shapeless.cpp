// expect: add: a body has a shape or is shapeless, not both; leave one out
// SPDX-License-Identifier: BSL-1.0
// A body that has a shape and has none.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, BoundingBoxes{}, Narrowphase<Sphere>{}, Projection{}};
#ifdef ANSATZ_MISTAKE
    world.add(Sphere{0.5 * metre}, position(metres(0, 2, 0)), mass(1.0 * kilogram), shapeless);
#else
    world.add(Sphere{0.5 * metre}, position(metres(0, 2, 0)), mass(1.0 * kilogram));
#endif
}
