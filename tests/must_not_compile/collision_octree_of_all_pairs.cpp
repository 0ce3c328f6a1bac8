// expect: what tests the bodies inside a cell is BoundingBoxes or SortAndSweep
// SPDX-License-Identifier: BSL-1.0
// A partition of something that cannot test what is inside its cells.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{SemiImplicitEuler{}, Octree<AllPairs>{}, Narrowphase<Sphere>{}, Impulse<>{}};
#else
    World world{SemiImplicitEuler{}, Octree<SortAndSweep>{}, Narrowphase<Sphere>{}, Impulse<>{}};
#endif
    world.step(0.01 * second);
}
