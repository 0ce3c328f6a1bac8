// expect: Pressure needs a volume, so a world of three dimensions
// SPDX-License-Identifier: BSL-1.0
// Pressure in a world of two dimensions.

#include <ansatz/soft_bodies/pressure.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{SemiImplicitEuler{}, Pressure{}, Space<double, 2>{}};
#else
    World world{SemiImplicitEuler{}, Pressure{}, Space<double, 3>{}};
#endif
    world.step(0.1 * second);
}
