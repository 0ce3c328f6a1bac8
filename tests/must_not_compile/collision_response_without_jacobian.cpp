// expect: an implicit integrator needs the Jacobian of every force, and this one has none that can be used
// SPDX-License-Identifier: BSL-1.0
// An implicit integrator asks each force how it changes.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

struct Push {
    using role = roles::Response;
    static constexpr Level level = Level::accelerations;
    static constexpr bool couples_bodies = true;
    using reads = Columns<Position>;
    template <class S> using State = PenaltyContacts<S>;
    template <class S> struct In {
        explicit In(const Push&) {}
        void couple(auto&, const auto&) const {}
    };
};

int main() {
#ifdef ANSATZ_MISTAKE
    World world{ImplicitEuler{}, BoundingBoxes{}, Narrowphase<Sphere>{}, Push{}};
#else
    World world{SemiImplicitEuler{}, BoundingBoxes{}, Narrowphase<Sphere>{}, Push{}};
#endif
    world.step(0.01 * second);
}
