// expect: a response that does not change what it acts on
// SPDX-License-Identifier: BSL-1.0
// An impulse at the level of positions.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

struct Stick {
    using role = roles::Response;
#ifdef ANSATZ_MISTAKE
    static constexpr Level level = Level::positions;
#else
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
