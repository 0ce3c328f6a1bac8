// expect: the datum is not of the type that the world keeps
// SPDX-License-Identifier: BSL-1.0
// A name for a number.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, Datum<int>{}};
#ifdef ANSATZ_MISTAKE
    world.add(datum("seven"));
#else
    world.add(datum(7));
#endif
}
