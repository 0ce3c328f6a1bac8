// expect: a vector has another dimension than its world
// SPDX-License-Identifier: BSL-1.0
// A position of the plane in a world of three dimensions.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, Gravity{}, Drag{}};
#ifdef ANSATZ_MISTAKE
    world.add(position(metres(0, 10)));
#else
    world.add(position(metres(0, 10, 0)));
#endif
}
