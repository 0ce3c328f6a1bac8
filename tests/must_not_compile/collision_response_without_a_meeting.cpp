// expect: a response with a wrong signature; its In<S> needs `void respond(const auto& contact, auto& a, auto& b, const auto& meeting) const`
// SPDX-License-Identifier: BSL-1.0
// One argument too few.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

struct Stick {
    using role = roles::Response;
    static constexpr Level level = Level::velocities;
    using writes = Columns<Velocity>;
    template <class S> struct In {
        explicit In(const Stick&) {}
#ifdef ANSATZ_MISTAKE
        void respond(const auto&, auto& a, auto& b) const {
#else
        void respond(const auto&, auto& a, auto& b, const auto&) const {
#endif
            a.template get<Velocity>() = b.template get<Velocity>();
    }
};
}
;

int main() {
    World world{SemiImplicitEuler{}, Gravity{}, BoundingBoxes{}, Narrowphase<Sphere>{}, Stick{}};
    world.step(0.01 * second);
}
