// expect: two policies of this world have the same name
// SPDX-License-Identifier: BSL-1.0
// With friction and without: a contact would be answered twice.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{SemiImplicitEuler{}, BoundingBoxes{}, Narrowphase<Sphere>{}, Impulse<>{}, Impulse<Friction>{}};
#else
    World world{SemiImplicitEuler{}, BoundingBoxes{}, Narrowphase<Sphere>{}, Impulse<Friction>{}};
#endif
    world.step(0.01 * second);
}
