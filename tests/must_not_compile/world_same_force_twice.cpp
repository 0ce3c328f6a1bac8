// expect: World has the same policy twice; each type of policy stands once in the list
// SPDX-License-Identifier: BSL-1.0
// A force that is listed twice.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{SemiImplicitEuler{}, Gravity{}, Gravity{}};
#else
    World world{SemiImplicitEuler{}, Gravity{}};
#endif
    world.step(0.1 * second);
}
