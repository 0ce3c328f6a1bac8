// expect: a response whose columns the world cannot read
// SPDX-License-Identifier: BSL-1.0
// A number is no column.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

struct Stick {
    using role = roles::Response;
    static constexpr Level level = Level::velocities;
#ifdef ANSATZ_MISTAKE
    using writes = Columns<Velocity>;
    using reads = Columns<int>;
#else
    using writes = Columns<Velocity>;
#endif
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
