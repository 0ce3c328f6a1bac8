// expect: this world keeps no datum of yours; add Datum<T>{} to its policies
// SPDX-License-Identifier: BSL-1.0
// Asking for a datum in a world without.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, Gravity{}, Drag{}};
    auto ball = world.add(position(metres(0, 10, 0)));
#ifdef ANSATZ_MISTAKE
    (void)world.datum(ball);
#else
    (void)world.position(ball);
#endif
}
