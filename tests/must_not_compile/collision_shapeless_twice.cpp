// expect: add: a property is given twice
// SPDX-License-Identifier: BSL-1.0
// What is said twice was meant for something else.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, BoundingBoxes{}, Narrowphase<Sphere>{}, Projection{}};
#ifdef ANSATZ_MISTAKE
    world.add(shapeless, position(metres(0, 2, 0)), mass(1.0 * kilogram), shapeless);
#else
    world.add(shapeless, position(metres(0, 2, 0)), mass(1.0 * kilogram));
#endif
}
