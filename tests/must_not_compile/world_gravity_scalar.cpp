// expect: one number where a vector belongs; give each of its components
// SPDX-License-Identifier: BSL-1.0
// Gravity has a direction.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{SemiImplicitEuler{}, Gravity{-9.81 * metre_per_second_squared}};
#else
    World world{SemiImplicitEuler{}, Gravity{metres_per_second_squared(0, -9.81, 0)}};
#endif
    world.step(0.1 * second);
}
