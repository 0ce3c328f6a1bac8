// SPDX-License-Identifier: BSL-1.0
// A shape says its bounding box; how two meet is a function beside it.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>
#include <cmath>

using namespace ansatz;

//! [model]
/// A disc in the plane of the first two axes, as a sphere that is flat: it meets its like.
struct Puck {
    using shape = Puck;
    static constexpr bool bounded = true;
    static constexpr std::string_view name = "Puck";
    Parameter<unit::Length> radius = 1.0 * metre;

    template <class S> struct In {
        using description = Puck;
        typename S::Length radius;
        explicit In(const Puck& puck) : radius(S::convert(puck.radius)) {}
        void bounds(const typename S::Position& x, typename S::Position& lower, typename S::Position& upper) const {
            auto half = x.value();
            half.setConstant(radius.value());
            lower = x - S::Position::from_value(half);
            upper = x + S::Position::from_value(half);
        }
    };
};
template <class S>
bool collide(const Puck::In<S>& a, const typename S::Position& xa, const Puck::In<S>& b, const typename S::Position& xb,
             Touch<S>& touch) {
    const auto between = xa - xb;
    const auto distance = norm(between);
    touch.depth = a.radius + b.radius - distance;
    if (!(touch.depth.value() > 0) || !(distance.value() > 0)) return false;
    touch.normal = between.value() / distance.value(); // from b to a
    touch.point = 0.5 * (xa + xb);
    return true;
}
//! [model]

int main() {
    World world{SemiImplicitEuler{}, SortAndSweep{}, Narrowphase<Puck>{}, Impulse{}};
    const auto a = world.add(Puck{}, velocity(metres_per_second(2, 0, 0)), mass(1.0 * kilogram), restitution(1.0));
    const auto b = world.add(Puck{}, position(metres(3, 0, 0)), mass(1.0 * kilogram), restitution(1.0));
    for (int i = 0; i < 100; ++i) world.step(0.01 * second);
    return std::abs(world.velocity(a).value()[0]) < 1e-9 && std::abs(world.velocity(b).value()[0] - 2) < 1e-9 ? 0 : 1;
}
