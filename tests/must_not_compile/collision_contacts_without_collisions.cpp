// expect: bodies of this world do not collide; add a broadphase, a narrowphase and a response
// SPDX-License-Identifier: BSL-1.0
// Contacts, where nothing collides.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, Gravity{}};
#ifdef ANSATZ_MISTAKE
    return int(world.contacts().size());
#else
    return int(world.size());
#endif
}
