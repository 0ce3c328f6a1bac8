// expect: World has more than one narrowphase; keep one
// SPDX-License-Identifier: BSL-1.0
// Two policies in a role for one.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{SemiImplicitEuler{},          BoundingBoxes{}, Layers{}, Narrowphase<Sphere>{},
                Narrowphase<Sphere, Plane>{}, Impulse<>{}};
#else
    World world{SemiImplicitEuler{}, BoundingBoxes{}, Layers{}, Narrowphase<Sphere>{}, Impulse<>{}};
#endif
    world.step(0.01 * second);
}
