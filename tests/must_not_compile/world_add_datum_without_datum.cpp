// expect: this world keeps no datum of yours; add Datum<T>{} to its policies
// SPDX-License-Identifier: BSL-1.0
// A datum in a world without.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{SemiImplicitEuler{}};
#else
    World world{SemiImplicitEuler{}, Datum<int>{}};
#endif
    world.add(datum(7));
}
