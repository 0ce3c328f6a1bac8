// expect: a Space has 2 or 3 dimensions
// SPDX-License-Identifier: BSL-1.0
// Nobody lives in four dimensions.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{Space<double, 4>{}, SemiImplicitEuler{}};
#else
    World world{Space<double, 3>{}, SemiImplicitEuler{}};
#endif
    world.step(0.1 * second);
}
