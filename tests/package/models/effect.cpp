// SPDX-License-Identifier: BSL-1.0
// An effect changes columns at a named place of the step.

#include <ansatz/world.hpp>

using namespace ansatz;

//! [model]
/// Bodies come in again at the other side.
struct WrapAround {
    using role = roles::Effect;
    using writes = Columns<Position>;
    static constexpr Place place = Place::after_integration;
    Parameter<unit::Length> width = 10.0 * metre;

    template <class S> struct In {
        typename S::Scalar width;
        explicit In(const WrapAround& wrap) : width(S::convert(wrap.width).value()) {}
        void apply(typename S::Position& x, const auto&) const {
            auto place = x.value();
            if (place[0] >= width) place[0] -= width;
            if (place[0] < 0) place[0] += width;
            x = S::Position::from_value(place);
        }
    };
};
//! [model]

int main() {
    World world{SemiImplicitEuler{}, WrapAround{}};
    const auto ship = world.add(position(metres(9, 0, 0)), velocity(metres_per_second(1, 0, 0)));
    for (int i = 0; i < 4; ++i) world.step(0.5 * second);
    return world.position(ship) == metres(1, 0, 0) && world.velocity(ship) == metres_per_second(1, 0, 0) ? 0 : 1;
}
