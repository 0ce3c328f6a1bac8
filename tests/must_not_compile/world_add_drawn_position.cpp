// expect: the world itself writes this column
// SPDX-License-Identifier: BSL-1.0
// A column that only the world writes.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
    World world{SemiImplicitEuler{}, Interpolation{}};
#ifdef ANSATZ_MISTAKE
    world.add(with<DrawnPosition>(metres(1, 2, 3)));
#else
    world.add(position(metres(1, 2, 3)));
#endif
}
