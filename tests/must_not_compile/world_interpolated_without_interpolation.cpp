// expect: this world does not remember where its bodies were; add Interpolation{} to its policies
// SPDX-License-Identifier: BSL-1.0
// In between of what?

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{SemiImplicitEuler{}};
#else
    World world{SemiImplicitEuler{}, Interpolation{}};
#endif
    auto ball = world.add();
    (void)interpolated_position(world, ball, 0.5);
}
