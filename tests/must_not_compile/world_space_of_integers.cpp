// expect: the scalar of a Space is a real number type
// SPDX-License-Identifier: BSL-1.0
// Whole numbers cannot integrate.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{Space<int, 3>{}, SemiImplicitEuler{}};
#else
    World world{Space<float, 3>{}, SemiImplicitEuler{}};
#endif
    world.step(0.1f * second);
}
