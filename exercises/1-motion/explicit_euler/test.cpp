// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on explicit Euler (notes 1.6.1).

#include "tools/exercises/expect.hpp"

#include <ansatz/world.hpp>

using namespace ansatz;
using namespace ansatz::workbook;

namespace {

struct Body {
    VectorQuantity<unit::Length, 3> x = metres(1, 2, 0);
    VectorQuantity<unit::Velocity, 3> v = metres_per_second(3, 4, 0);
};
const auto a = metres_per_second_squared(0.5, -10, 0);
const auto dt = 0.1 * second;

Body after_one_step() {
    Body body;
    exercise::ExplicitEuler::advance(Stage<0>{}, body.x, body.v, a, dt);
    return body;
}

} // namespace

TEST_CASE("the position moves with the velocity of the beginning", "[task-1][old-velocity]") {
    expect_near("the position after one step of 0.1 s, from (1, 2, 0) m at (3, 4, 0) m/s", after_one_step().x,
                metres(1.3, 2.4, 0), 1e-12 * metre,
                "x' = x + v dt with the velocity before it changes, and nothing else: explicit means that only what is "
                "known goes in.");
}

TEST_CASE("the acceleration adds to the velocity", "[task-1][velocity-adds-up]") {
    expect_near("the velocity after one step of 0.1 s, from (3, 4, 0) m/s under (0.5, -10, 0) m/s^2",
                after_one_step().v, metres_per_second(3.05, 3, 0), 1e-12 * metre_per_second,
                "v' = v + a dt: what it had, and what the step brings.");
}

TEST_CASE("a body that falls in a world is where the scheme says, not where it really would be", "[task-1][fall]") {
    World world{exercise::ExplicitEuler{}, Gravity{metres_per_second_squared(0, -8, 0)}};
    const auto ball = world.add(position(metres(0, 100, 0)), velocity(metres_per_second(1, 2, 0)));
    std::vector<double> yours, right;
    for (int n = 0; n <= 16; ++n) {
        if (n > 0) world.step(0.125 * second);
        const double t = 0.125 * n;
        yours.push_back(y(world.position(ball)).value());
        right.push_back(100 + 2 * t - 0.5 * 8 * t * (t - 0.125)); // the sum of v_0 + a i dt over i = 0 .. n-1, times dt
    }
    expect_path("the height in 2 s of free fall", "m", yours, right, 0.125, 1e-9,
                "Explicit Euler is too high by g dt t / 2 = 1 m here: it never knows the velocity that the step will "
                "end with.");
}

TEST_CASE("the energy of a spring grows by a factor in every step", "[task-2][energy-factor]") {
    for (const double rate : {2000.0, 60.0, 8.0}) {
        const auto omega = 10.0 / second;
        const auto step = 1.0 / rate * second;
        const double yours = exercise::energy_factor(omega, step);
        auto place = 0.3 * metre;
        auto speed = -2.0 * metre_per_second;
        const auto before = speed * speed + omega * omega * place * place;
        ansatz::ExplicitEuler::advance(Stage<0>{}, place, speed, -omega * omega * (0.3 * metre), step);
        const double right = (speed * speed + omega * omega * place * place) / before;
        std::ostringstream what;
        what << "the energy after a step over that before, omega = 10/s at " << rate << " steps/s";
        expect_near(what.str(), yours, right, 1e-12,
                    "Square x + v dt and v - omega^2 x dt and add them as the energy does: the mixed terms fall out.");
    }
}

std::vector<double> probe(int task) {
    if (task == 1) {
        const Body body = after_one_step();
        return {x(body.x).value(), y(body.x).value(), x(body.v).value(), y(body.v).value()};
    }
    return {exercise::energy_factor(10.0 / second, 0.02 * second), exercise::energy_factor(3.0 / second, 0.5 * second)};
}
