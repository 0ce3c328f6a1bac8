// SPDX-License-Identifier: BSL-1.0
// A force between bodies: it sees all of them, and adds forces in pairs.

#include <ansatz/world.hpp>
#include <cmath>

using namespace ansatz;

//! [model]
/// Each body is pulled to the next by a constant force.
struct Follow {
    using role = roles::Force;
    using reads = Columns<Position>;
    static constexpr bool couples_bodies = true;
    Parameter<unit::Force> pull = 1.0 * newton;

    template <class S> struct In {
        typename S::template ScalarOf<unit::Force> pull;
        explicit In(const Follow& follow) : pull(S::convert(follow.pull)) {}
        void couple(auto& view, const auto&) const {
            for (std::size_t i = 0; i + 1 < view.size(); ++i) {
                const auto way = view.template get<Position>(i + 1) - view.template get<Position>(i);
                const auto distance = norm(way);
                if (distance.value() > 0) view.add_force_pair(i, i + 1, (pull / distance) * way);
            }
        }
    };
};
//! [model]

int main() {
    World world{SemiImplicitEuler{}, Follow{}};
    const auto a = world.add(mass(1.0 * kilogram));
    const auto b = world.add(position(metres(100, 0, 0)), mass(3.0 * kilogram));
    for (int i = 0; i < 100; ++i) world.step(0.01 * second);
    const bool newton = std::abs(world.velocity(a).value()[0] + 3 * world.velocity(b).value()[0]) < 1e-12;
    return newton && std::abs(world.velocity(a).value()[0] - 1) < 1e-12 ? 0 : 1;
}
