// expect: none of this world's responses reads a restitution, so it stores none
// SPDX-License-Identifier: BSL-1.0
// Who only moves bodies apart gives nothing back.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, BoundingBoxes{}, Narrowphase<Sphere>{}, Projection{}};
#ifdef ANSATZ_MISTAKE
    world.add(Sphere{0.5 * metre}, mass(1.0 * kilogram), restitution(0.5));
#else
    world.add(Sphere{0.5 * metre}, mass(1.0 * kilogram));
#endif
}
