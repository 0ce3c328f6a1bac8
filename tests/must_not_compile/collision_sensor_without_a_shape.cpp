// expect: add: a sensor without a shape notices nobody; give it one
// SPDX-License-Identifier: BSL-1.0
// A sensor that is nowhere.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, BoundingBoxes{}, Narrowphase<Sphere>{}, Impulse<>{}};
#ifdef ANSATZ_MISTAKE
    world.add(sensor, fixed);
#else
    world.add(Sphere{2.0 * metre}, sensor, fixed);
#endif
}
