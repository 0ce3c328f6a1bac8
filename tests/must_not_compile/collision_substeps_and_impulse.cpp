// expect: World has a response that takes a step in substeps (SoftSubsteps) and one that changes velocities at its end (Impulse)
// SPDX-License-Identifier: BSL-1.0
// Either answers a contact by itself; both would answer it twice.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{SemiImplicitEuler{}, BoundingBoxes{}, Narrowphase<Sphere>{}, SoftSubsteps<>{}, Impulse{}};
#else
    World world{SemiImplicitEuler{}, BoundingBoxes{}, Narrowphase<Sphere>{}, Impulse{}};
#endif
    world.step(0.01 * second);
}
