// expect: a response that does not say on what it acts
// SPDX-License-Identifier: BSL-1.0
// Nobody can guess on what it acts.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

struct Stick {
    using role = roles::Response;
#ifndef ANSATZ_MISTAKE
    static constexpr Level level = Level::velocities;
#endif
    using writes = Columns<Velocity>;
    template <class S> struct In {
        explicit In(const Stick&) {}
        void respond(const auto&, auto& a, auto& b, const auto&) const {
            a.template get<Velocity>() = b.template get<Velocity>();
        }
    };
};

int main() {
    World world{SemiImplicitEuler{}, Gravity{}, BoundingBoxes{}, Narrowphase<Sphere>{}, Stick{}};
    world.step(0.01 * second);
}
