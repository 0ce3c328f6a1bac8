// expect: an observer whose observe the world cannot call
// SPDX-License-Identifier: BSL-1.0
// An observer that would silently never be called.

#include <ansatz/world.hpp>

using namespace ansatz;

#ifdef ANSATZ_MISTAKE
struct Watch {
    using role = roles::Observer;
    using reads = Columns<Velocity>;
    void observe() {}
};
#else
struct Watch {
    using role = roles::Observer;
    using reads = Columns<Velocity>;
    void observe(const auto&) {}
};
#endif

int main() {
    World world{SemiImplicitEuler{}, Watch{}};
    world.step(0.1 * second);
}
