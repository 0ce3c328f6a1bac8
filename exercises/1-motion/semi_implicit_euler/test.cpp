// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on semi-implicit Euler (notes 1.6.3).

#include "tools/exercises/expect.hpp"

#include <ansatz/world.hpp>

using namespace ansatz;
using namespace ansatz::workbook;

static_assert(
    StagedIntegratorIn<exercise::SemiImplicitEuler, Space<>>,
    "SemiImplicitEuler is no integrator of stages any more: keep role, writes, stages, and the parameters of advance");

namespace {

struct Body {
    VectorQuantity<unit::Length, 2> x = metres(1, 2);
    VectorQuantity<unit::Velocity, 2> v = metres_per_second(3, 4);
};
const auto dt = 0.1 * second;

Body after_one_step() {
    Body body;
    exercise::SemiImplicitEuler::advance(Stage<0>{}, body.x, body.v, metres_per_second_squared(0.5, -10), dt);
    return body;
}

/// A mass on a spring.
struct OnSpring {
    Quantity<unit::Frequency> omega;
    Quantity<unit::Length> x = 0.3 * metre;
    Quantity<unit::Velocity> v = -2.0 * metre_per_second;

    /// A step of a method whose velocity goes first.
    void step(Quantity<unit::Time> dt, Quantity<unit::Frequency> c = 0.0 / second) {
        ansatz::SemiImplicitEuler::advance(Stage<0>{}, x, v, -omega * omega * x - c * v, dt);
    }
};

} // namespace

TEST_CASE("the acceleration adds to the velocity", "[task-1][velocity-adds-up]") {
    expect_near("the velocity after one step of 0.1 s, from (3, 4) m/s under (0.5, -10) m/s^2", after_one_step().v,
                metres_per_second(3.05, 3), 1e-12 * metre_per_second,
                "v' = v + a dt: what it had, and what the step brings.");
}

TEST_CASE("the position moves with the velocity of the end", "[task-1][new-velocity]") {
    expect_near("the position after one step of 0.1 s, from (1, 2) m at (3, 4) m/s under (0.5, -10) m/s^2",
                after_one_step().x, metres(1.305, 2.3), 1e-12 * metre,
                "x' = x + v' dt with the velocity v' = (3.05, 3) m/s that the step ends with, and nothing else.");
}

TEST_CASE("a body that falls in a world is where the scheme says, not where it really would be", "[task-1][fall]") {
    World world{exercise::SemiImplicitEuler{}, Gravity{metres_per_second_squared(0, -8, 0)}};
    const auto ball = world.add(position(metres(0, 100, 0)), velocity(metres_per_second(1, 2, 0)));
    std::vector<double> yours, right;
    for (int n = 0; n <= 16; ++n) {
        if (n > 0) world.step(0.125 * second);
        const double t = 0.125 * n;
        yours.push_back(y(world.position(ball)).value());
        right.push_back(100 + 2 * t - 0.5 * 8 * t * (t + 0.125)); // the sum of v_0 + a i dt over i = 1 .. n, times dt
    }
    expect_path("the height in 2 s of free fall", "m", yours, right, 0.125, 1e-9,
                "Semi-implicit Euler is too low by g dt t / 2 = 1 m here: it falls in each step as fast as it will at "
                "its end.");
}

TEST_CASE("the amplitude of a spring neither grows nor fades in ten thousand steps", "[task-1][amplitude]") {
    // The method keeps v^2 + omega^2 x^2 - dt omega^2 x v. On this ellipse through x = 1 m, v = 0 the largest x is 1 m
    // over the root of 1 - (omega dt / 2)^2. A thousand steps come close enough to it to be beyond 1 m.
    const auto omega = 8.0 / second;
    const auto most = 1.0 / std::sqrt(1 - 0.4 * 0.4) * metre;
    auto x = 1.0 * metre, farthest = 0.0 * metre;
    auto v = 0.0 * metre_per_second;
    int step = 0;
    while (step < 10000 && abs(x) < 1e6 * metre) {
        exercise::SemiImplicitEuler::advance(Stage<0>{}, x, v, -omega * omega * x, dt);
        if (++step > 9000 || abs(x) > 1e6 * metre) farthest = max(farthest, abs(x));
    }
    std::ostringstream text;
    text
        << "a mass on a spring, let go at 1 m, omega dt = 0.8: the farthest of the last 1000 of 10 000 steps\n    "
           "yours  "
        << (farthest < 1e-9 * metre ? "0 m: it has faded" : workbook::detail::shown(farthest))
        << (step < 10000 ? " already in step " + std::to_string(step) : "") << "\n    right  between 1 m and " << most
        << "\nWith the velocity first the state stays on an ellipse for ever; other orders spiral outwards or inwards.";
    expect(farthest >= 1.0 * metre && farthest <= most + 1e-9 * metre, text.str());
}

TEST_CASE("the kept energy is the same after every step", "[task-2][kept]") {
    for (const double rate : {2000.0, 60.0, 8.0}) {
        OnSpring mass{10.0 / second};
        const auto step = 1.0 / rate * second;
        const auto before = exercise::kept_energy(mass.x, mass.v, mass.omega, step);
        for (int i = 0; i < 100; ++i) {
            mass.step(step);
            std::ostringstream what;
            what << "the kept energy of a mass on a spring, omega = 10/s at " << rate << " steps/s, after step "
                 << i + 1;
            // Rounding: some 1e-16 of the energy in each of 100 steps, tenfold.
            expect_agree(what.str(), "yours before the steps", before, "yours after it",
                         exercise::kept_energy(mass.x, mass.v, mass.omega, step), 1e-13 * abs(before),
                         "Put v' = v - omega^2 x dt and x' = x + v' dt into it: every term that is new must fall out.");
        }
    }
}

TEST_CASE("the kept energy becomes the energy as the step becomes short", "[task-2][short-steps]") {
    const OnSpring mass{10.0 / second};
    const auto energy = 0.5 * (mass.v * mass.v + mass.omega * mass.omega * mass.x * mass.x);
    // The term with x v is linear in dt, so that this combination of two steps is free of it.
    const auto at = [&](Quantity<unit::Time> step) { return exercise::kept_energy(mass.x, mass.v, mass.omega, step); };
    expect_near("the kept energy of x = 0.3 m, v = -2 m/s, omega = 10/s, continued to a step of no length",
                2.0 * at(0.001 * second) - at(0.002 * second), energy, 1e-11 * energy,
                "The term with x v has the factor dt; what is left without it is the energy, (v^2 + omega^2 x^2) / 2.");
}

TEST_CASE("below the largest step it stays, above it explodes", "[task-3][limit]") {
    for (const double c : {0.0, 2.0, 30.0}) {
        const auto omega = 3.0 / second;
        const auto limit = exercise::largest_step(omega, c / second);
        // Beyond the limit by a thousandth, a step multiplies one state by about -1.001 or more: e^100 after 100 000.
        // Below it the states run on ellipses, some twenty times as long as wide, or fade.
        auto reach = [&](double part) {
            OnSpring mass{omega};
            auto farthest = mass.x;
            for (int i = 0; i < 100000 && farthest < 1e20 * metre; ++i) {
                mass.step(part * limit, c / second);
                farthest = max(farthest, abs(mass.x));
            }
            return farthest;
        };
        std::ostringstream text;
        text << "the largest step for omega = 3/s and a damping of " << c << "/s\n    yours  " << limit;
        const std::string start = text.str();
        expect(is_finite(limit) && limit > 0.0 * second, start + "\nA step is a positive time.");
        expect(reach(0.999) < 1e6 * metre,
               start + ", and with a step of 0.999 of it the mass comes beyond 1e6 m: it is too long.\n"
                       "The motion explodes as soon as a step turns a state round and makes it larger.");
        expect(reach(1.001) > 1e6 * metre,
               start + ", but with a step of 1.001 of it the mass still stays where it is: it is too short.\n"
                       "Put x' = -x and v' = -v into both lines of the method.");
    }
}

TEST_CASE("damping makes the largest step shorter", "[task-3][damping]") {
    const auto free = exercise::largest_step(5.0 / second, 0.0 / second);
    const auto damped = exercise::largest_step(5.0 / second, 4.0 / second);
    std::ostringstream text;
    text << "the largest step for omega = 5/s\n    yours  " << free << " without damping, " << damped
         << " with c = 4/s\n"
         << "The one with damping must be the shorter: explicit damping pushes too, and in a long step it pushes too "
            "far.";
    expect(damped < free, text.str());
}

std::vector<double> probe(int task) {
    if (task == 1) {
        const Body body = after_one_step();
        return {x(body.x).value(), y(body.x).value(), x(body.v).value(), y(body.v).value()};
    }
    if (task == 2) {
        std::vector<double> energies;
        for (const double v : {-2.0, 1.0})
            energies.push_back(
                exercise::kept_energy(0.3 * metre, v * metre_per_second, 10.0 / second, 0.02 * second).value());
        return energies;
    }
    return {exercise::largest_step(3.0 / second, 0.0 / second).value(),
            exercise::largest_step(3.0 / second, 2.0 / second).value(),
            exercise::largest_step(5.0 / second, 1.0 / second).value()};
}
