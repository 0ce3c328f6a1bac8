// expect: a bare number where a quantity belongs; multiply it with its unit
// SPDX-License-Identifier: BSL-1.0
// A bare number for a coefficient.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{SemiImplicitEuler{}, Drag{0.05}};
#else
    World world{SemiImplicitEuler{}, Drag{0.05 / second}};
#endif
    world.step(0.1 * second);
}
