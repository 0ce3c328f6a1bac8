// expect: two policies of this world have the same name
// SPDX-License-Identifier: BSL-1.0
// Two winds of one name would be one in a saved file.

#include <ansatz/world.hpp>

using namespace ansatz;

struct Wind : Gravity {};

int main() {
#ifdef ANSATZ_MISTAKE
    World world{SemiImplicitEuler{}, Gravity{}, Wind{}};
#else
    World world{SemiImplicitEuler{}, Gravity{}};
#endif
}
