// expect: unknown policy: this type names no role
// SPDX-License-Identifier: BSL-1.0
// A number among the policies.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{SemiImplicitEuler{}, 9.81};
#else
    World world{SemiImplicitEuler{}, Gravity{}};
#endif
    world.step(0.1 * second);
}
