// expect: add: a body has one shape; add several bodies for several shapes
// SPDX-License-Identifier: BSL-1.0
// A body with two shapes.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, BoundingBoxes{}, Narrowphase<Sphere, Plane>{}, Impulse<>{}};
#ifdef ANSATZ_MISTAKE
    world.add(Sphere{0.5 * metre}, mass(1.0 * kilogram), Plane::ground());
#else
    world.add(Sphere{0.5 * metre}, mass(1.0 * kilogram));
#endif
}
