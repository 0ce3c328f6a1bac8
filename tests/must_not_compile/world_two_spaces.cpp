// expect: World has more than one Space; keep one
// SPDX-License-Identifier: BSL-1.0
// Two spaces.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{Space<float, 2>{}, Space<double, 2>{}, SemiImplicitEuler{}};
#else
    World world{Space<float, 2>{}, SemiImplicitEuler{}};
#endif
    world.step(0.1 * second);
}
