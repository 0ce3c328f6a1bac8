// expect: a Narrowphase of shapes that never meet: those without a box (planes) meet only those that have one
// SPDX-License-Identifier: BSL-1.0
// Planes never meet each other.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{SemiImplicitEuler{}, BoundingBoxes{}, Narrowphase<Plane>{}, Impulse<>{}};
#else
    World world{SemiImplicitEuler{}, BoundingBoxes{}, Narrowphase<Plane, Sphere>{}, Impulse<>{}};
#endif
    world.step(0.01 * second);
}
