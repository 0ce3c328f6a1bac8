// expect: a response at Level::accelerations is a force between bodies; it needs `static constexpr bool couples_bodies = true;`
// SPDX-License-Identifier: BSL-1.0
// A penalty that is no force between bodies.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

struct Push {
    using role = roles::Response;
    static constexpr Level level = Level::accelerations;
#ifndef ANSATZ_MISTAKE
    static constexpr bool couples_bodies = true;
#endif
    using reads = Columns<Position>;
    template <class S> using State = PenaltyContacts<S>;
    template <class S> struct In {
        explicit In(const Push&) {}
        void couple(auto&, const auto&) const {}
    };
};

int main() {
    World world{SemiImplicitEuler{}, Gravity{}, BoundingBoxes{}, Narrowphase<Sphere>{}, Push{}};
    world.step(0.01 * second);
}
