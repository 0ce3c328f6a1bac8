// expect: a bare number where a quantity belongs; multiply it with its unit, e.g. 0.5 * metre
// SPDX-License-Identifier: BSL-1.0
// A radius is a length.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, BoundingBoxes{}, Narrowphase<Sphere>{}, Impulse<>{}};
#ifdef ANSATZ_MISTAKE
    world.add(Sphere{0.5}, mass(1.0 * kilogram));
#else
    world.add(Sphere{0.5 * metre}, mass(1.0 * kilogram));
#endif
}
