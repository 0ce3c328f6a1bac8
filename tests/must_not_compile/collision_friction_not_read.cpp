// expect: none of this world's responses knows friction, so it stores none; ask for it, e.g. Impulse<Friction>{}
// SPDX-License-Identifier: BSL-1.0
// Friction that no response asks for.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, BoundingBoxes{}, Narrowphase<Sphere>{}, Impulse<>{}};
#ifdef ANSATZ_MISTAKE
    world.add(Sphere{0.5 * metre}, mass(1.0 * kilogram), friction(0.5));
#else
    world.add(Sphere{0.5 * metre}, mass(1.0 * kilogram), restitution(0.5));
#endif
}
