// expect: a bare number where a quantity belongs; multiply it with its unit
// SPDX-License-Identifier: BSL-1.0
// A stiffness has a unit.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{SemiImplicitEuler{}, BoundingBoxes{}, Narrowphase<Sphere>{}, Penalty{1e4}};
#else
    World world{SemiImplicitEuler{}, BoundingBoxes{}, Narrowphase<Sphere>{}, Penalty{1e4 * newton_per_metre}};
#endif
    world.step(0.01 * second);
}
