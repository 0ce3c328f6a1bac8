// expect: a scalar quantity of another unit belongs here; multiply the number with its unit, e.g. 1.0 / 60 * second
// SPDX-License-Identifier: BSL-1.0
// A length for a time.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, Gravity{}, Drag{}};
#ifdef ANSATZ_MISTAKE
    world.step(0.1 * metre);
#else
    world.step(0.1 * second);
#endif
}
