// expect: a force that cannot be bound to a space
// SPDX-License-Identifier: BSL-1.0
// A force without In<S>.

#include <ansatz/world.hpp>

using namespace ansatz;

#ifdef ANSATZ_MISTAKE
struct Wind {
    using role = roles::Force;
    using reads = Columns<>;
    auto acceleration(const auto&) const { return metres_per_second_squared(1, 0, 0); }
};
#else
struct Wind {
    using role = roles::Force;
    using reads = Columns<>;
    template <class S> struct In {
        explicit In(const Wind&) {}
        typename S::Acceleration acceleration(const auto&) const { return {}; }
    };
};
#endif

int main() {
    World world{SemiImplicitEuler{}, Wind{}};
    world.add(position(metres(0, 10, 0)));
    world.step(0.1 * second);
}
