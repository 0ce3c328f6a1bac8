// expect: Wind blows on triangles, so in a world of three dimensions
// SPDX-License-Identifier: BSL-1.0
// Wind in a world of two dimensions.

#include <ansatz/soft_bodies/wind.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{SemiImplicitEuler{}, Wind{}, Space<double, 2>{}};
#else
    World world{SemiImplicitEuler{}, Wind{}, Space<double, 3>{}};
#endif
    world.step(0.1 * second);
}
