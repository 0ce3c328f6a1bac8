// expect: what tests the bodies inside a cell is BoundingBoxes or SortAndSweep
// SPDX-License-Identifier: BSL-1.0
// A partition inside the cells of another.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    const Boxes<Space<>> boxes;
#ifdef ANSATZ_MISTAKE
    find_pairs(UniformGrid<Octree<>>{}, boxes);
#else
    find_pairs(UniformGrid<BoundingBoxes>{}, boxes);
#endif
}
