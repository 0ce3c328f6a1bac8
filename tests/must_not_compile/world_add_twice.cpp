// expect: a property is given twice
// SPDX-License-Identifier: BSL-1.0
// Two positions.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, Gravity{}, Drag{}};
#ifdef ANSATZ_MISTAKE
    world.add(position(metres(0, 10, 0)), position(metres(0, 20, 0)));
#else
    world.add(position(metres(0, 10, 0)));
#endif
}
