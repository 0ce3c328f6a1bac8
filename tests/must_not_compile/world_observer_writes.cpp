// expect: an observer sees and never changes
// SPDX-License-Identifier: BSL-1.0
// An observer that declares to change something.

#include <ansatz/world.hpp>

using namespace ansatz;

#ifdef ANSATZ_MISTAKE
struct Watch {
    using role = roles::Observer;
    using writes = Columns<Velocity>;
};
#else
struct Watch {
    using role = roles::Observer;
    using reads = Columns<Velocity>;
};
#endif

int main() {
    World world{SemiImplicitEuler{}, Watch{}};
    world.step(0.1 * second);
}
