// expect: a bare number where a quantity belongs; multiply it with its unit
// SPDX-License-Identifier: BSL-1.0
// A box has half widths, which are lengths.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, BoundingBoxes{}, Narrowphase<Box>{}, Impulse<>{}};
#ifdef ANSATZ_MISTAKE
    world.add(Box{Eigen::Vector3d(1, 1, 1)}, fixed);
#else
    world.add(Box{metres(1, 1, 1)}, fixed);
#endif
}
