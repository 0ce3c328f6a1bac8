// expect: a response that acts in the next step keeps its contacts until then
// SPDX-License-Identifier: BSL-1.0
// A penalty that forgets its contacts.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

struct Push {
    using role = roles::Response;
    static constexpr Level level = Level::accelerations;
    static constexpr bool couples_bodies = true;
    using reads = Columns<Position>;
#ifndef ANSATZ_MISTAKE
    template <class S> using State = PenaltyContacts<S>;
#endif
    template <class S> struct In {
        explicit In(const Push&) {}
        void couple(auto&, const auto&) const {}
    };
};

int main() {
    World world{SemiImplicitEuler{}, Gravity{}, BoundingBoxes{}, Narrowphase<Sphere>{}, Push{}};
    world.step(0.01 * second);
}
