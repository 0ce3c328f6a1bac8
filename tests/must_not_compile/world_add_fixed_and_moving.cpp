// expect: a body is one of fixed, moving or resting
// SPDX-License-Identifier: BSL-1.0
// Fixed and moving.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, Gravity{}, Drag{}};
#ifdef ANSATZ_MISTAKE
    world.add(fixed, moving);
#else
    world.add(fixed);
#endif
}
