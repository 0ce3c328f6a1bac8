// expect: none of this world's responses knows friction, so it stores none; ask for it, e.g. Impulse<Friction>{}
// SPDX-License-Identifier: BSL-1.0
// The same, of a body that is there.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, BoundingBoxes{}, Narrowphase<Sphere>{}, SoftSubsteps<>{}};
    const auto ball = world.add(Sphere{0.5 * metre}, mass(1.0 * kilogram));
#ifdef ANSATZ_MISTAKE
    world.write<Friction>(ball, Quantity<unit::Dimensionless>(0.5));
#else
    world.write<Restitution>(ball, Quantity<unit::Dimensionless>(0.5));
#endif
}
