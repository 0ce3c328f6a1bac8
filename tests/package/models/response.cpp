// SPDX-License-Identifier: BSL-1.0
// A response answers contacts: here one by one, by what it does to velocities.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>
#include <cmath>

using namespace ansatz;

//! [model]
/// Both go on with their common velocity.
struct Clay {
    using role = roles::Response;
    static constexpr Level level = Level::velocities;
    using writes = Columns<Velocity>;

    template <class S> struct In {
        explicit In(const Clay&) {}
        void respond(const auto&, auto& a, auto& b, const auto&) const {
            const auto wa = a.template get<InverseMass>(), wb = b.template get<InverseMass>();
            auto &va = a.template get<Velocity>(), &vb = b.template get<Velocity>();
            const typename S::Velocity common = (typename S::Scalar(1) / (wa + wb)) * (wb * va + wa * vb);
            va = vb = common;
        }
    };
};
//! [model]

int main() {
    World world{SemiImplicitEuler{}, AllPairs{}, Narrowphase<Sphere>{}, Clay{}};
    const auto a = world.add(Sphere{0.5 * metre}, velocity(metres_per_second(4, 0, 0)), mass(1.0 * kilogram));
    const auto b = world.add(Sphere{0.5 * metre}, position(metres(2, 0, 0)), mass(3.0 * kilogram));
    for (int i = 0; i < 60; ++i) world.step(0.01 * second);
    return std::abs(world.velocity(a).value()[0] - 1) < 1e-12 && world.velocity(a) == world.velocity(b) ? 0 : 1;
}
