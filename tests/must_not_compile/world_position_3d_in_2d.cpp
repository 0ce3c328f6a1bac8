// expect: a vector has another dimension than its world
// SPDX-License-Identifier: BSL-1.0
// A position of space in a world of two dimensions.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{Space<double, 2>{}, SemiImplicitEuler{}};
#ifdef ANSATZ_MISTAKE
    world.add(position(metres(0, 10, 0)));
#else
    world.add(position(metres(0, 10)));
#endif
}
