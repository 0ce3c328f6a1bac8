// expect: position takes a vector of lengths; write e.g. position(metres(0, 10, 0))
// SPDX-License-Identifier: BSL-1.0
// A height is not a position.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, Gravity{}, Drag{}};
#ifdef ANSATZ_MISTAKE
    world.add(position(10.0 * metre));
#else
    world.add(position(metres(0, 10, 0)));
#endif
}
