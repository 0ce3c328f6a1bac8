// SPDX-License-Identifier: BSL-1.0
// A law of one body: what it answers is an acceleration, or a force that the library divides by the mass.

#include <ansatz/world.hpp>
#include <cmath>

using namespace ansatz;

//! [model]
/// A spring to the origin, of any dimension.
struct ToTheOrigin {
    using role = roles::Force;
    using reads = Columns<Position>;
    Parameter<unit::Stiffness> stiffness = 4.0 * newton_per_metre;
    static constexpr std::string_view name = "ToTheOrigin";
    static void parameters(auto& self, auto&& visit) { visit("stiffness", self.stiffness); }

    template <class S> struct In {
        typename S::template ScalarOf<unit::Stiffness> k;
        explicit In(const ToTheOrigin& law) : k(S::convert(law.stiffness)) {}
        typename S::Force force(const typename S::Position& x, const auto&) const { return -(k * x); }
    };
};
//! [model]

int main() {
    World world{VelocityVerlet{}, ToTheOrigin{}};
    const auto ball = world.add(position(metres(1, 0, 0)), mass(1.0 * kilogram)); // omega = 2 / s
    for (int i = 0; i < 1000; ++i) world.step(0.001 * second);
    return std::abs(world.position(ball).value()[0] - std::cos(2.0)) < 1e-5 ? 0 : 1;
}
