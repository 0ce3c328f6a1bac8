// expect: this world puts no bodies to rest; add Rest{} to its policies
// SPDX-License-Identifier: BSL-1.0
// Asleep in a world that knows no sleep.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{SemiImplicitEuler{}};
#else
    World world{SemiImplicitEuler{}, Rest{}};
#endif
    world.add(resting);
}
