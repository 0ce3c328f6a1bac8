// expect: restitution and friction take a plain number, e.g. restitution(0.8), friction(0.3)
// SPDX-License-Identifier: BSL-1.0
// A coefficient has no unit.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, BoundingBoxes{}, Narrowphase<Sphere>{}, Impulse<>{}};
#ifdef ANSATZ_MISTAKE
    world.add(Sphere{0.5 * metre}, mass(1.0 * kilogram), restitution(0.5 * metre));
#else
    world.add(Sphere{0.5 * metre}, mass(1.0 * kilogram), restitution(0.5));
#endif
}
