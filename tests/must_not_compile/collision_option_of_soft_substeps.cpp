// expect: the options of SoftSubsteps are Friction and Coloured, each once, e.g. SoftSubsteps<Friction>{}
// SPDX-License-Identifier: BSL-1.0
// An option that soft substeps do not have.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{SemiImplicitEuler{}, BoundingBoxes{}, Narrowphase<Sphere>{}, SoftSubsteps<Rest>{}};
#else
    World world{SemiImplicitEuler{}, BoundingBoxes{}, Narrowphase<Sphere>{}, SoftSubsteps<Friction>{}};
#endif
    world.step(0.01 * second);
}
