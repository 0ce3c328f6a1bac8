// expect: set: this world has no such policy; see the list in its type
// SPDX-License-Identifier: BSL-1.0
// A policy that is not there.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, Gravity{}, Drag{}};
#ifdef ANSATZ_MISTAKE
    world.set(FrameDrag{});
#else
    world.set(Drag{});
#endif
}
