// expect: no member named
// SPDX-License-Identifier: BSL-1.0
// Contacts, where nothing collides: the member comes with the module.

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
