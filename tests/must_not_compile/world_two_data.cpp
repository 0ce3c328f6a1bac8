// expect: World has more than one Datum
// SPDX-License-Identifier: BSL-1.0
// Two data of the user: put them into one struct.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{SemiImplicitEuler{}, Datum<int>{}, Datum<float>{}};
#else
    World world{SemiImplicitEuler{}, Datum<std::pair<int, float>>{}};
#endif
    world.step(0.1 * second);
}
