// expect: the option of Impulse is Friction, e.g. Impulse<Friction>{}
// SPDX-License-Identifier: BSL-1.0
// An option that impulses do not have.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{SemiImplicitEuler{}, BoundingBoxes{}, Narrowphase<Sphere>{}, Impulse<Restitution>{}};
#else
    World world{SemiImplicitEuler{}, BoundingBoxes{}, Narrowphase<Sphere>{}, Impulse<Friction>{}};
#endif
    world.step(0.01 * second);
}
