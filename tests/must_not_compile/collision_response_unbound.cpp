// expect: a response that cannot be bound to a space; it needs `template <class S> struct In`
// SPDX-License-Identifier: BSL-1.0
// A response whose In is not made from it.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

struct Stick {
    using role = roles::Response;
    static constexpr Level level = Level::velocities;
    using writes = Columns<Velocity>;
    template <class S> struct In {
#ifndef ANSATZ_MISTAKE
        explicit In(const Stick&) {}
#endif
        void respond(const auto&, auto& a, auto& b, const auto&) const {
            a.template get<Velocity>() = b.template get<Velocity>();
        }
    };
};

int main() {
    World world{SemiImplicitEuler{}, Gravity{}, BoundingBoxes{}, Narrowphase<Sphere>{}, Stick{}};
    world.step(0.01 * second);
}
