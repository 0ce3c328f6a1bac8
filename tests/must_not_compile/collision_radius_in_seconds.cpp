// expect: a quantity of another unit where this parameter's unit belongs
// SPDX-License-Identifier: BSL-1.0
// A radius is a length.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, BoundingBoxes{}, Narrowphase<Sphere>{}, Impulse<>{}};
#ifdef ANSATZ_MISTAKE
    world.add(Sphere{0.5 * second}, mass(1.0 * kilogram));
#else
    world.add(Sphere{0.5 * metre}, mass(1.0 * kilogram));
#endif
}
