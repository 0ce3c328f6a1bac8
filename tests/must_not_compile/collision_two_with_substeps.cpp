// expect: World has more than one response that takes a step in substeps; keep one
// SPDX-License-Identifier: BSL-1.0
// Two that take the step in substeps.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{SemiImplicitEuler{}, BoundingBoxes{}, Narrowphase<Sphere>{}, SoftSubsteps<>{},
                SoftSubsteps<Friction>{}};
#else
    World world{SemiImplicitEuler{}, BoundingBoxes{}, Narrowphase<Sphere>{}, SoftSubsteps<Friction>{}};
#endif
    world.step(0.01 * second);
}
