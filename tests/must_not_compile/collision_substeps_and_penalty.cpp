// expect: World has a response that takes a step in substeps (SoftSubsteps) and one whose contacts are forces of the next step (Penalty)
// SPDX-License-Identifier: BSL-1.0
// Either holds bodies apart by itself; both would hold them twice.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{SemiImplicitEuler{}, BoundingBoxes{}, Narrowphase<Sphere>{}, SoftSubsteps<>{}, Penalty{}};
#else
    World world{SemiImplicitEuler{}, BoundingBoxes{}, Narrowphase<Sphere>{}, Penalty{}};
#endif
    world.step(0.01 * second);
}
