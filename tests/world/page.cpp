// SPDX-License-Identifier: BSL-1.0

// What docs/world.md shows, so that it is compiled and true.

#include "tests/catch.hpp"

#include <ansatz/world.hpp>

#include <cmath>

using namespace ansatz;

namespace {
//! [wind]
struct Wind { // a = c (w - v)
    using role = roles::Force;
    using reads = Columns<Velocity>;
    Parameter<unit::Frequency> grip = 0.5 / second;
    VectorParameter<unit::Velocity> wind = metres_per_second(4, 0, 0);

    template <class S> struct In { // bound to a space: converted once
        typename S::template ScalarOf<unit::Frequency> grip;
        typename S::Velocity wind;
        explicit In(const Wind& w) : grip(S::convert(w.grip)), wind(S::convert(w.wind)) {}
        typename S::Acceleration acceleration(const typename S::Velocity& v, const auto&) const { return grip * (wind - v); }
    };
};
//! [wind]
} // namespace

TEST_CASE("the page about worlds shows a force that works", "[world][page]") {
    World world{RungeKutta4{}, Wind{}};
    const auto leaf = world.add();
    for (int i = 0; i < 600; ++i) world.step(0.01 * second);
    const double expected = 4 * (1 - std::exp(-3.0)); // w (1 - e^-ct)
    CHECK(std::abs(in(x(world.velocity(leaf)), metre_per_second) - expected) <= 1e-9);
}

TEST_CASE("the page about worlds shows the library used in pieces", "[world][page]") {
    using S = Space<float, 3>;
    //! [pieces]
    const Gravity::In<S> gravity(Gravity{});
    auto x = S::Position();
    auto v = S::Velocity();
    const TimeStep<S> dt(S::convert(0.5 * second), S::convert(0.5 * second)); // this step, and the one before
    const auto a = gravity.acceleration(0);
    SemiImplicitEuler::advance(Stage<0>{}, x, v, a, dt);
    //! [pieces]
    CHECK(std::abs(y(v).value() + 4.905f) <= 1e-6f);
    CHECK(std::abs(y(x).value() + 2.4525f) <= 1e-6f);
}
