// expect: because it takes it by value
// SPDX-License-Identifier: BSL-1.0
// An effect that changes a copy.

#include <ansatz/world.hpp>

using namespace ansatz;

#ifdef ANSATZ_MISTAKE
struct Damp {
    using role = roles::Effect;
    using writes = Columns<Velocity>;
    static constexpr Place place = Place::after_integration;
    template <class S> struct In {
        explicit In(const Damp&) {}
        void apply(typename S::Velocity v, const auto&) const { v *= 0.5; }
    };
};
#else
struct Damp {
    using role = roles::Effect;
    using writes = Columns<Velocity>;
    static constexpr Place place = Place::after_integration;
    template <class S> struct In {
        explicit In(const Damp&) {}
        void apply(typename S::Velocity& v, const auto&) const { v *= 0.5; }
    };
};
#endif

int main() {
    World world{SemiImplicitEuler{}, Damp{}};
    world.add(position(metres(0, 10, 0)));
    world.step(0.1 * second);
}
