// expect: bodies of this world collide, and this one would meet nothing; give it a shape
// SPDX-License-Identifier: BSL-1.0
// A body whose shape was forgotten would fall through the ground.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, Gravity{}, BoundingBoxes{}, Narrowphase<Sphere, Plane>{}, Projection{}};
    world.add(Plane::ground(), fixed);
#ifdef ANSATZ_MISTAKE
    world.add(position(metres(0, 2, 0)), mass(1.0 * kilogram));
#else
    world.add(Sphere{0.5 * metre}, position(metres(0, 2, 0)), mass(1.0 * kilogram));
    world.add(shapeless, position(metres(0, 2, 0)), mass(1.0 * kilogram));
#endif
}
