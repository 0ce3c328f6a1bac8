// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on Verlet's method (notes 1.6.4).

#include "tools/exercises/expect.hpp"

#include <ansatz/world.hpp>

using namespace ansatz;
using namespace ansatz::workbook;

static_assert(
    StagedIntegratorIn<exercise::Verlet, Space<>>,
    "Verlet is no integrator of stages any more: keep role, writes, scratch and stages, the parameters of every "
    "function, and what each of them answers (a velocity, a velocity, a position)");

namespace {

using Length = Quantity<unit::Length>;
using Time = Quantity<unit::Time>;
using StepOf = TimeStep<Space<>>;

const auto dt = 0.1 * second;
const auto omega = 1.0 / second;

/// A body that flies under a constant acceleration: exactly where it is, and how fast.
const auto a = metres_per_second_squared(0.5, -10);
auto place(Time t) { return metres(1, 2) + t * metres_per_second(3, 4) + 0.5 * t * t * a; }
auto speed(Time t) { return metres_per_second(3, 4) + t * a; }

/// The position and the one before.
struct Pair {
    VectorQuantity<unit::Length, 2> now, before;
};
/// From its exact places `last` ago and now, one step of `next`.
Pair flown(Time last, Time next) {
    Pair body{place(0.0 * second), place(-last)};
    VectorQuantity<unit::Velocity, 2> unused;
    exercise::Verlet::advance(Stage<1>{}, body.now, body.before, unused, a, StepOf(next, last));
    return body;
}

/// A mass on a spring, omega = 1/s, from 1 m and 0.5 m/s: exactly where it is.
Length on_spring(Time t) { return (std::cos(omega * t) + 0.5 * std::sin(omega * t)) * metre; }

/// How far it is off after a second in n steps.
double error_of_start(int n) {
    const auto step = 1.0 / n * second;
    Length now = 1.0 * metre;
    Length before = exercise::Verlet::history(now, 0.5 * metre_per_second, -omega * omega * now, step);
    for (int i = 0; i < n; ++i) {
        const Length next = now + (now - before) - omega * omega * now * step * step;
        before = now;
        now = next;
    }
    return abs(now - on_spring(1.0 * second)) / metre;
}

} // namespace

TEST_CASE("the next position follows from the last two", "[task-1][step]") {
    expect_near(
        "the position after one step of 0.1 s of a body that flies with (3, 4) m/s under (0.5, -10) m/s^2 at (1, 2) m",
        flown(dt, dt).now, place(dt), 1e-12 * metre,
        "x + (x - previous) + a dt^2: under a constant acceleration, and from exact positions, it is exact.");
}

TEST_CASE("the previous position becomes the present one", "[task-1][shift]") {
    expect_near(
        "the previous position after a step that began at (1, 2) m", flown(dt, dt).before, metres(1, 2), 1e-12 * metre,
        "After the step the previous position is the one from which the step began: keep x before you change it.");
}

TEST_CASE("a step of another length is taken from the velocity, not from the difference", "[task-1][other-step]") {
    for (const double part : {0.5, 3.0}) {
        std::ostringstream what;
        what << "the position of the same body after a step of " << part * 0.1 << " s that follows one of 0.1 s";
        expect_near(what.str(), flown(dt, part * dt).now, place(part * dt), 1e-12 * metre,
                    "(x - previous) / dt.previous is the velocity half a step of dt.previous ago; the middle of the "
                    "next step is "
                    "(dt + dt.previous) / 2 later.");
    }
}

TEST_CASE("run backwards, it comes back", "[task-1][backwards]") {
    // The positions of the scheme in exact arithmetic are the same forwards and backwards; rounding grows with n^2 at
    // most.
    Length now = 1.0 * metre, before = now;
    VectorQuantity<unit::Velocity, 2> unused;
    const int n = 1000;
    auto run = [&] {
        for (int i = 0; i < n; ++i)
            exercise::Verlet::advance(Stage<1>{}, now, before, unused, -omega * omega * now, StepOf(dt, dt));
    };
    run();
    std::swap(now, before);
    run();
    expect_near("where a mass on a spring is that began at 1 m, after 1000 steps and 1000 back", now, 1.0 * metre,
                1e-9 * metre,
                "With the last two positions swapped the same formula gives the position before them: it has no "
                "direction of time.");
}

TEST_CASE("the mean velocity is the way over the time", "[task-2][mean]") {
    expect_near("the mean velocity of a step of 0.1 s from (0.6, 1) m to (1, 2) m",
                exercise::Verlet::mean_velocity(metres(1, 2), metres(0.6, 1), dt), metres_per_second(4, 10),
                1e-12 * metre_per_second, "Where it is now minus where it was, over the time between them.");
}

TEST_CASE("the velocity now is half a step of acceleration later than the mean", "[task-2][present]") {
    for (const double length : {0.1, 0.4}) {
        const auto step = length * second;
        const auto mean = (place(0.0 * second) - place(-step)) / step;
        std::ostringstream what;
        what << "the velocity at the end of a step of " << length << " s, with the mean velocity " << mean
             << " under (0.5, -10) m/s^2";
        expect_near(what.str(), exercise::Verlet::velocity_now(mean, a, step), metres_per_second(3, 4),
                    1e-12 * metre_per_second,
                    "Under a constant acceleration the mean is the velocity of the middle of the step, and the end is "
                    "half a step later.");
    }
}

TEST_CASE("a flying body was where its history says", "[task-3][constant-acceleration]") {
    expect_near("where a body was 0.1 s ago that flies with (3, 4) m/s under (0.5, -10) m/s^2 at (1, 2) m",
                exercise::Verlet::history(metres(1, 2), metres_per_second(3, 4), a, dt), place(-dt), 1e-12 * metre,
                "Put t = -dt into x + v t + a t^2 / 2: the sign of v turns round, that of a does not.");
}

TEST_CASE("started with its history, the method is of second order", "[task-3][order]") {
    std::vector<double> errors;
    for (int n = 40; n <= 320; n *= 2) errors.push_back(error_of_start(n));
    expect_order("a mass on a spring after a second", errors, 2, 0.05,
                 "The method itself is of second order; an error of the start that goes with dt^2 shows in every later "
                 "position, and makes it first.");
}

TEST_CASE("in a world, a throw is exact after every step", "[task-3][throw]") {
    World world{Space<double, 2>{}, exercise::Verlet{}, Gravity{metres_per_second_squared(0.5, -10)}};
    const auto ball = world.add(position(metres(1, 2)), velocity(metres_per_second(3, 4)));
    for (const double length : {0.1, 0.1, 0.05, 0.2}) world.step(length * second);
    expect_near("the position of a thrown ball after steps of 0.1, 0.1, 0.05 and 0.2 s", world.position(ball),
                place(0.45 * second), 1e-12 * metre,
                "All tasks together: history makes the position before the first step, advance the others.");
    expect_near("the velocity of the ball then", world.velocity(ball), speed(0.45 * second), 1e-11 * metre_per_second,
                "World::velocity asks mean_velocity and velocity_now.");
}

std::vector<double> probe(int task) {
    if (task == 1) {
        const Pair even = flown(dt, dt), uneven = flown(dt, 0.25 * second);
        return {x(even.now).value(),   y(even.now).value(),   x(even.before).value(),  y(even.before).value(),
                x(uneven.now).value(), y(uneven.now).value(), x(uneven.before).value()};
    }
    if (task == 2) {
        const auto mean = exercise::Verlet::mean_velocity(metres(1, 2), metres(0.6, 1), dt);
        const auto now = exercise::Verlet::velocity_now(metres_per_second(4, 10), a, dt);
        return {x(mean).value(), y(mean).value(), x(now).value(), y(now).value()};
    }
    const auto before = exercise::Verlet::history(metres(1, 2), metres_per_second(3, 4), a, dt);
    return {x(before).value(), y(before).value()};
}
