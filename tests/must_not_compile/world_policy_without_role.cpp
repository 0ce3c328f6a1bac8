// expect: unknown policy: this type names no role; give it one
// SPDX-License-Identifier: BSL-1.0
// A policy that does not say what it is.

#include <ansatz/world.hpp>

using namespace ansatz;

#ifdef ANSATZ_MISTAKE
struct Wind {
    using reads = Columns<>;
    template <class S> struct In {
        explicit In(const Wind&) {}
        typename S::Acceleration acceleration(const auto&) const { return {}; }
    };
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
