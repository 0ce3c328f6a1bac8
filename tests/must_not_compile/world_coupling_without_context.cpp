// expect: a force with a wrong signature
// SPDX-License-Identifier: BSL-1.0
// couple(view, context), not couple(view).

#include <ansatz/world.hpp>

using namespace ansatz;

#ifdef ANSATZ_MISTAKE
struct Magnet {
    using role = roles::Force;
    using reads = Columns<Velocity>;
    static constexpr bool couples_bodies = true;
    template <class S> struct In {
        explicit In(const Magnet&) {}
        void couple(auto&) const {}
    };
};
#else
struct Magnet {
    using role = roles::Force;
    using reads = Columns<Velocity>;
    static constexpr bool couples_bodies = true;
    template <class S> struct In {
        explicit In(const Magnet&) {}
        void couple(auto&, const auto&) const {}
    };
};
#endif

int main() {
    World world{SemiImplicitEuler{}, Magnet{}};
    world.add(mass(2.0 * kilogram));
    world.step(0.1 * second);
}
