// expect: the world itself writes this column
// SPDX-License-Identifier: BSL-1.0
// A column that only the world writes.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, Rest{}, Keep<InverseMass>{}};
    const auto body = world.add(mass(1.0 * kilogram));
#ifdef ANSATZ_MISTAKE
    world.write<RestTime>(body, 3.0 * second);
#else
    world.set_mass(body, 2.0 * kilogram);
#endif
}
