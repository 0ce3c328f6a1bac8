// expect: Keep stores columns
// SPDX-License-Identifier: BSL-1.0
// Keep is given a column, not a unit.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{SemiImplicitEuler{}, Keep<unit::Mass>{}};
#else
    World world{SemiImplicitEuler{}, Keep<InverseMass>{}};
#endif
    world.step(0.1 * second);
}
