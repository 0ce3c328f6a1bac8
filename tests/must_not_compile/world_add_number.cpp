// expect: add takes named properties
// SPDX-License-Identifier: BSL-1.0
// A number is no property.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, Gravity{}, Drag{}};
#ifdef ANSATZ_MISTAKE
    world.add(10.0);
#else
    world.add();
#endif
}
