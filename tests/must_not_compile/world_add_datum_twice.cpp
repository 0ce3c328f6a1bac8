// expect: a property is given twice
// SPDX-License-Identifier: BSL-1.0
// Two data.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, Datum<int>{}};
#ifdef ANSATZ_MISTAKE
    world.add(datum(1), datum(2));
#else
    world.add(datum(1));
#endif
}
