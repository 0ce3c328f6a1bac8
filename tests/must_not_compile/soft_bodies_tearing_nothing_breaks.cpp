// expect: a world with Tearing in which nothing breaks; write Springs<Breaking>{} or Ropes<Breaking>{} among its policies
// SPDX-License-Identifier: BSL-1.0
// A sheet tears where a spring breaks.

#include <ansatz/soft_bodies/tearing.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{SemiImplicitEuler{}, Springs<>{}, Tearing<>{}};
#else
    World world{SemiImplicitEuler{}, Springs<Breaking>{}, Tearing<>{}};
#endif
    world.step(0.1 * second);
}
