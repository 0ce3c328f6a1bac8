// SPDX-License-Identifier: BSL-1.0

// What docs/world.md shows, so that it is compiled and true.

#include "tests/catch.hpp"

#include <ansatz/world.hpp>

#include <cmath>
#include <vector>

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
        typename S::Acceleration acceleration(const typename S::Velocity& v, const auto&) const {
            return grip * (wind - v);
        }
    };
};
//! [wind]

//! [midpoint]
struct Midpoint { // half a step, and then the whole one with what was found there
    using role = roles::Integrator;
    using writes = Columns<Position, Velocity>;
    using scratch = Columns<ScratchVector<unit::Length>, ScratchVector<unit::Velocity>>; // kept from stage to stage
    static constexpr int stages = 2;
    static constexpr double nodes[] = {0, 0.5}; // when in the step the forces are asked
    static constexpr int order = 2;

    static void advance(Stage<0>, auto& x, auto& v, auto& x0, auto& v0, const auto& a, const auto& dt) {
        x0 = x;
        v0 = v;
        x += 0.5 * dt * v;
        v += 0.5 * dt * a;
    }
    static void advance(Stage<1>, auto& x, auto& v, auto& x0, auto& v0, const auto& a, const auto& dt) {
        x = x0 + v * dt;
        v = v0 + a * dt;
    }
};
//! [midpoint]

//! [speed_limit]
struct SpeedLimit {
    using role = roles::Effect;
    using writes = Columns<Velocity>;
    static constexpr Place place = Place::after_integration;
    Parameter<unit::Velocity> most = 10.0 * metre_per_second;

    template <class S> struct In {
        typename S::Speed most;
        explicit In(const SpeedLimit& limit) : most(S::convert(limit.most)) {}
        void apply(typename S::Velocity& v, const auto&) const {
            const auto speed = norm(v);
            if (speed > most) v *= typename S::Scalar(most / speed);
        }
    };
};
//! [speed_limit]

//! [recorder]
struct Recorder {
    using role = roles::Observer;
    using reads = Columns<Position>;
    std::vector<Quantity<unit::Length>> heights;

    void observe(const auto& view) { // after each step
        view.for_each([&](std::size_t slot) { heights.push_back(y(view.template get<Position>(slot))); });
    }
};
//! [recorder]
} // namespace

TEST_CASE("the page about worlds shows an integrator, an effect and an observer that work", "[world][page]") {
    World world{Midpoint{}, Gravity{}, SpeedLimit{}, Recorder{}};
    const auto stone = world.add(position(metres(0, 100, 0)), velocity(metres_per_second(3, 0, 0)));
    for (int i = 0; i < 10; ++i) world.step(0.05 * second);
    CHECK(std::abs(y(world.position(stone)).value() - (100 - 0.5 * 9.81 * 0.25)) < 1e-12); // exact for a constant force
    for (int i = 0; i < 90; ++i) world.step(0.05 * second);
    CHECK(std::abs(norm(world.velocity(stone)).value() - 10) < 1e-12);
    CHECK(world.get<Recorder>().heights.size() == 100);
    CHECK(world.get<Recorder>().heights.back() == y(world.position(stone)));

    auto error = [](int n) { // of second order where the force changes
        World falling{Midpoint{}, Wind{}};
        const auto leaf = falling.add();
        for (int i = 0; i < n; ++i) falling.step(2.0 / n * second);
        return std::abs(x(falling.velocity(leaf)).value() - 4 * (1 - std::exp(-1.0)));
    };
    CHECK(std::abs(std::log2(error(100) / error(200)) - Midpoint::order) < 0.02);
}

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
