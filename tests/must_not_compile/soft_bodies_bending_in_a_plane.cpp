// expect: Bending is of triangles that fold, so of a world of three dimensions
// SPDX-License-Identifier: BSL-1.0
// Bending in a world of two dimensions.

#include <ansatz/soft_bodies/bending.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{SemiImplicitEuler{}, Bending{}, Space<double, 2>{}};
#else
    World world{SemiImplicitEuler{}, Bending{}, Space<double, 3>{}};
#endif
    world.step(0.1 * second);
}
