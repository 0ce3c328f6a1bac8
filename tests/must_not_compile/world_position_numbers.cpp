// expect: position takes one vector of lengths
// SPDX-License-Identifier: BSL-1.0
// Three numbers instead of a vector.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}};
#ifdef ANSATZ_MISTAKE
    world.add(position(1, 2, 3));
#else
    world.add(position(metres(1, 2, 3)));
#endif
}
