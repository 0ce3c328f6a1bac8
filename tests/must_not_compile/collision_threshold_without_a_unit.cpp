// expect: a bare number where a quantity belongs; multiply it with its unit
// SPDX-License-Identifier: BSL-1.0
// The slowest approach that bounces is a velocity.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{SemiImplicitEuler{}, BoundingBoxes{}, Narrowphase<Sphere>{}, Impulse<>{.threshold = 0.5}};
#else
    World world{SemiImplicitEuler{}, BoundingBoxes{}, Narrowphase<Sphere>{},
                Impulse<>{.threshold = 0.5 * metre_per_second}};
#endif
    world.step(0.01 * second);
}
