// expect: a policy asks for the time that it did not declare; add Clock to its columns
// SPDX-License-Identifier: BSL-1.0
// A force between bodies that depends on time and does not say so.

#include <ansatz/world.hpp>

using namespace ansatz;

#ifdef ANSATZ_MISTAKE
struct Magnet {
    using role = roles::Force;
    using reads = Columns<>;
    static constexpr bool couples_bodies = true;
    template <class S> struct In {
        explicit In(const Magnet&) {}
        void couple(auto&, const auto& context) const { (void)context.time(); }
    };
};
#else
struct Magnet {
    using role = roles::Force;
    using reads = Columns<Clock>;
    static constexpr bool couples_bodies = true;
    template <class S> struct In {
        explicit In(const Magnet&) {}
        void couple(auto&, const auto& context) const { (void)context.time(); }
    };
};
#endif

int main() {
    World world{SemiImplicitEuler{}, Magnet{}};
    world.add(mass(2.0 * kilogram));
    world.step(0.1 * second);
}
