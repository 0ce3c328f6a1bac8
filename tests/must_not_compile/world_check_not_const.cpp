// expect: a policy whose check the world cannot call
// SPDX-License-Identifier: BSL-1.0
// A check that would silently never be called.

#include <ansatz/world.hpp>

using namespace ansatz;

#ifdef ANSATZ_MISTAKE
struct Wind {
    using role = roles::Force;
    using reads = Columns<>;
    void check() {}
    template <class S> struct In {
        explicit In(const Wind&) {}
        typename S::Acceleration acceleration(const auto&) const { return {}; }
    };
};
#else
struct Wind {
    using role = roles::Force;
    using reads = Columns<>;
    void check() const {}
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
