// expect: add takes named properties
// SPDX-License-Identifier: BSL-1.0
// A vector could be a position or anything else.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, Gravity{}, Drag{}};
#ifdef ANSATZ_MISTAKE
    world.add(metres(0, 10, 0));
#else
    world.add(position(metres(0, 10, 0)));
#endif
}
