// expect: the option of Tearing is Splitting, e.g. Tearing<Splitting>{.room = 200}
// SPDX-License-Identifier: BSL-1.0
// An option that Tearing does not have.

#include <ansatz/soft_bodies/tearing.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{SemiImplicitEuler{}, Springs<Breaking>{}, Tearing<Breaking>{}};
#else
    World world{SemiImplicitEuler{}, Springs<Breaking>{}, Tearing<Splitting>{.room = 10}};
#endif
    world.step(0.1 * second);
}
