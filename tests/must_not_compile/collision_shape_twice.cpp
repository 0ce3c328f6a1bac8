// expect: a Narrowphase names a shape twice; name each once
// SPDX-License-Identifier: BSL-1.0
// A shape that is named twice.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{SemiImplicitEuler{}, BoundingBoxes{}, Narrowphase<Sphere, Plane, Sphere>{}, Impulse<>{}};
#else
    World world{SemiImplicitEuler{}, BoundingBoxes{}, Narrowphase<Sphere, Plane>{}, Impulse<>{}};
#endif
    world.step(0.01 * second);
}
