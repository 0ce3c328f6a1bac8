// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on drag (notes 1.7).

#include "tools/exercises/expect.hpp"

#include <ansatz/world.hpp>

using namespace ansatz;
using namespace ansatz::workbook;

static_assert(EffectIn<exercise::Drag, Space<>> && EffectIn<exercise::Drag, Space<float, 2>>,
              "Drag is no effect any more: keep role, writes, place, and in In<S> the parameters of prepare and apply");

namespace {

using Rate = Quantity<unit::Frequency>;
using Time = Quantity<unit::Time>;

struct Body {
    VectorQuantity<unit::Length, 3> x;
    VectorQuantity<unit::Velocity, 3> v;
};

/// A body from (1, 2, 0) m with (3, -4, 0) m/s, with drag and nothing else.
Body after(Rate rate, int steps, Time dt) {
    World world{SemiImplicitEuler{}, exercise::Drag{rate}};
    const auto body = world.add(position(metres(1, 2, 0)), velocity(metres_per_second(3, -4, 0)));
    for (int i = 0; i < steps; ++i) world.step(dt);
    return {world.position(body), world.velocity(body)};
}
const auto at_first = metres_per_second(3, -4, 0);

} // namespace

TEST_CASE("in a step of dt the velocity falls by exp(-c dt)", "[task-1][factor]") {
    expect_near("the velocity after one step of 0.1 s at the rate 3/s, from (3, -4, 0) m/s",
                after(3.0 / second, 1, 0.1 * second).v, std::exp(-0.3) * at_first, 1e-12 * metre_per_second,
                "dv/dt = -c v has the solution v(t) = v(0) exp(-c t).");
}

TEST_CASE("the frame rate makes no difference", "[task-1][frame-rate]") {
    const auto thirty = after(0.6 / second, 30, 1.0 / 30 * second).v,
               hundred = after(0.6 / second, 120, 1.0 / 120 * second).v;
    expect_agree(
        "the velocity after a second at the rate 0.6/s, from (3, -4, 0) m/s", "yours in  30 steps", thirty,
        "yours in 120 steps", hundred, 1e-12 * metre_per_second,
        "A second must take the same part of the velocity however it is cut: f(dt) f(dt) = f(2 dt). Only exponentials "
        "do that.");
}

TEST_CASE("the body becomes slower, for steps of any length, and never turns round", "[task-1][only-slower]") {
    for (const double length : {0.01, 0.1, 1.0, 10.0}) {
        const auto v = after(5.0 / second, 1, length * second).v;
        std::ostringstream text;
        text << "the velocity after one step of " << length << " s at the rate 5/s\n    yours  " << v << "\n    before "
             << at_first
             << "\nThe factor is between 0 and 1, also for a step in which c dt is 50: nothing is pushed beyond zero.";
        expect(x(v) >= 0.0 * metre_per_second && x(v) < x(at_first) && y(v) <= 0.0 * metre_per_second &&
                   y(v) > y(at_first),
               text.str());
    }
}

TEST_CASE("a rate of zero is no drag", "[task-1][no-drag]") {
    expect_near("the velocity after ten steps at the rate 0/s", after(0.0 / second, 10, 0.1 * second).v, at_first,
                0.0 * metre_per_second, "exp(0) is 1, exactly.");
}

TEST_CASE("drag changes the velocity, not the position", "[task-1][position]") {
    // It acts after the integrator, so that the first step goes on as if there were none.
    expect_near("the position after one step of 0.1 s at the rate 3/s, from (1, 2, 0) m",
                after(3.0 / second, 1, 0.1 * second).x, metres(1.3, 1.6, 0), 1e-12 * metre,
                "The integrator has moved the body already; drag changes what it moves with next.");
}

TEST_CASE("in another space, with float and two dimensions", "[task-1][float]") {
    World world{Space<float, 2>{}, SemiImplicitEuler{}, exercise::Drag{3.0 / second}};
    const auto body = world.add(velocity(metres_per_second(3, -4)));
    for (int i = 0; i < 2; ++i) world.step(0.1 * second);
    // A float has seven digits.
    expect_near("the velocity of a body of floats after two steps of 0.1 s at the rate 3/s, from (3, -4) m/s",
                scalar_cast<double>(world.velocity(body)), std::exp(-0.6) * metres_per_second(3, -4),
                1e-5 * metre_per_second, "It is the same law in every space: v(t) = v(0) exp(-c t).");
}

TEST_CASE("the rate of a factor in each frame", "[task-2][rate]") {
    for (const double factor : {0.99, 0.5, 0.01}) {
        const auto rate = exercise::rate_of(factor, 60.0 / second);
        std::ostringstream what;
        what << "what your rate of " << rate << " leaves in a sixtieth of a second, for the factor " << factor
             << " in each of 60 frames";
        expect_near(what.str(), std::exp(-double(rate / (60.0 / second))), factor, 1e-12,
                    "exp(-c dt) must be the factor, with dt one over the frames a second; solve that for c.");
    }
}

TEST_CASE("a factor of one is no drag", "[task-2][rate-of-nothing]") {
    expect_near("the rate of the factor 1", exercise::rate_of(1, 60.0 / second), 0.0 / second, 1e-12 / second,
                "Nothing is taken, so the rate is zero.");
}

std::vector<double> probe(int task) {
    if (task == 2)
        return {exercise::rate_of(0.99, 60.0 / second).value(), exercise::rate_of(0.5, 30.0 / second).value()};
    std::vector<double> numbers;
    // Two rates: a number that takes no notice of the rate would pass for the factor of a frame.
    for (const auto& [rate, dt] : {std::pair{3.0, 0.02}, std::pair{3.0, 0.5}, std::pair{0.8, 0.5}}) {
        const Body body = after(rate / second, 2, dt * second);
        numbers.insert(numbers.end(), {x(body.x).value(), y(body.x).value(), x(body.v).value(), y(body.v).value()});
    }
    return numbers;
}
