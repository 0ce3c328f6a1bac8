// expect: add: bodies of this world do not collide, so it takes no shape
// SPDX-License-Identifier: BSL-1.0
// A shape, where nothing collides.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, Gravity{}};
#ifdef ANSATZ_MISTAKE
    world.add(Sphere{0.5 * metre});
#else
    world.add(position(metres(0, 1, 0)));
#endif
}
