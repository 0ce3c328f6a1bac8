// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on a spring in implicit Euler (notes 1.6.2 and 3).

#include "tools/exercises/expect.hpp"

#include <ansatz/world.hpp>

#include <complex>

using namespace ansatz;
using namespace ansatz::workbook;

namespace {

using exercise::OnSpring;
using exercise::State;
using Time = Quantity<unit::Time>;

OnSpring on_spring(double m, double k, double c) {
    return {m * kilogram, k * newton_per_metre, c * newton_second_per_metre};
}
/// A spring and the step that is taken with it.
struct Case {
    OnSpring body;
    Time h;
};
/// From soft to so stiff that omega h is 47, with less damping than the critical one, other masses and other steps.
const std::vector<Case>& cases() {
    static const std::vector<Case> all = {
        {on_spring(2, 50, 1), 0.02 * second},
        {on_spring(0.25, 40, 2), 0.1 * second},
        {on_spring(1, 1e6, 30), 1.0 / 60 * second},
        {on_spring(5, 4e7, 900), 1.0 / 60 * second},
    };
    return all;
}
const State starts[] = {{0.3 * metre, -2.0 * metre_per_second}, {-0.05 * metre, -1.5 * metre_per_second}};

std::string said(const Case& c) {
    std::ostringstream text;
    text << c.body.mass << " on a spring of " << c.body.stiffness << " with a damping of " << c.body.damping
         << ", a step of " << c.h;
    return text.str();
}
/// Calls `check(case, start, sentence)` for each spring and each start.
template <class Check> void for_each_step(Check&& check) {
    for (const auto& c : cases())
        for (const auto& start : starts) {
            std::ostringstream text;
            text << said(c) << ", from " << start.x << " with " << start.v;
            check(c, start, text.str());
        }
}
auto energy_of(const OnSpring& b, const State& s) { return 0.5 * (b.mass * s.v * s.v + b.stiffness * s.x * s.x); }

/// The closed form of the scheme. Nature multiplies one complex amplitude by exp(s t); implicit Euler divides it by
/// 1 - s h in each step. s is the root of m s^2 + c s + k = 0, with less damping than the critical one.
State after_steps(const Case& c, const State& start, int steps) {
    const double gamma = c.body.damping.value() / c.body.mass.value(), h = c.h.value();
    const double square = c.body.stiffness.value() / c.body.mass.value();
    const std::complex<double> s(-gamma / 2, std::sqrt(square - gamma * gamma / 4));
    // x is the real part of the amplitude, v that of s times the amplitude.
    const double x = start.x.value(), v = start.v.value();
    const std::complex<double> amplitude(x, (s.real() * x - v) / s.imag());
    const auto then = amplitude / std::pow(1.0 - s * h, steps);
    return {then.real() * metre, (s * then).real() * metre_per_second};
}

} // namespace

TEST_CASE("the new velocity solves the equation", "[task-1][equation]") {
    for_each_step([](const Case& c, const State& start, const std::string& what) {
        const auto& [m, k, damping] = c.body;
        const auto v = exercise::after_a_step(c.body, start, c.h).v;
        const auto at_the_end = start.x + c.h * v;
        // Rounded are a place of the size of x, times h k / m, and a velocity, times h c / m.
        const auto size = abs(start.v) + c.h * k / m * abs(start.x) + c.h * damping / m * abs(v);
        expect_agree(what + ": both sides of the equation, with your v'", "v' - v", v - start.v,
                     "-h (k x' + c v') / m, x' = x + h v'", -c.h * (k * at_the_end + damping * v) / m, 1e-13 * size,
                     "The force is that at the end of the step: the place and the velocity in it are the new ones. Put "
                     "x' = x + h v' into it, and solve for v'.");
    });
}

TEST_CASE("the place moves with the new velocity", "[task-1][place]") {
    for_each_step([](const Case& c, const State& start, const std::string& what) {
        const State end = exercise::after_a_step(c.body, start, c.h);
        expect_agree(what + ": the place after it", "your x'", end.x, "x + h v' with your v'", start.x + c.h * end.v,
                     1e-14 * (abs(start.x) + c.h * abs(end.v)), "Implicit Euler moves with the velocity of the end.");
    });
}

TEST_CASE("sixty steps lead where the scheme leads", "[task-1][sixty]") {
    for_each_step([](const Case& c, const State& start, const std::string& what) {
        State state = start;
        std::vector<double> yours, right;
        for (int n = 0; n <= 60; ++n) {
            if (n > 0) state = exercise::after_a_step(c.body, state, c.h);
            yours.push_back(state.x.value());
            right.push_back(after_steps(c, start, n).x.value());
        }
        // Each step rounds a state that is not larger than the first one.
        expect_path(what + ": the place", "m", yours, right, c.h.value(), 1e-12,
                    "Each step divides one complex number by 1 - s h, where s is the root of m s^2 + c s + k = 0.");
    });
}

TEST_CASE("however stiff the spring and however long the step, the energy never grows", "[task-1][never-grows]") {
    for (const double k : {10.0, 1e4, 1e8})
        for (const double h : {0.001, 0.05, 2.0}) {
            const Case c{on_spring(0.5, k, 0), h * second};
            State state = starts[0];
            for (int i = 0; i < 200; ++i) {
                const auto before = energy_of(c.body, state);
                state = exercise::after_a_step(c.body, state, c.h);
                const auto after = energy_of(c.body, state);
                std::ostringstream text;
                text << said(c) << ": the energy in step " << i + 1 << "\n    yours  from " << before << " to " << after
                     << "\nImplicit Euler takes energy in every step, and never gives any, at any stiffness.";
                // A thousandth of a billionth is left to the rounding of the two energies.
                expect(is_finite(after) && after <= (1 + 1e-12) * before, text.str());
            }
        }
}

TEST_CASE("however strong the damper, it stops a body and never turns it round", "[task-1][damper]") {
    for (const double m : {0.5, 8.0})
        for (const double c : {0.1, 20.0, 1e5}) {
            const Case damper{on_spring(m, 0, c), 0.1 * second};
            const auto v = exercise::after_a_step(damper.body, starts[0], damper.h).v;
            std::ostringstream text;
            text << said(damper) << ", from " << starts[0].v << "\n    yours  " << v
                 << "\nA damper alone makes a body slower: the new velocity is between zero and the old one.";
            expect(v < 0.0 * metre_per_second && v > starts[0].v, text.str());
        }
}

TEST_CASE("for short steps it is the motion of nature, with an error of the order of the step", "[task-1][order]") {
    const OnSpring body = on_spring(2, 50, 1);
    std::vector<double> errors;
    for (const int steps : {400, 800, 1600}) {
        const Case c{body, 1.0 / steps * second};
        State state = starts[0];
        for (int i = 0; i < steps; ++i) state = exercise::after_a_step(body, state, c.h);
        const double gamma = 0.5, omega = std::sqrt(25 - gamma * gamma / 4);
        const double x = starts[0].x.value(), v = starts[0].v.value();
        const double exact =
            std::exp(-gamma / 2) * (x * std::cos(omega) + (v + gamma / 2 * x) / omega * std::sin(omega));
        errors.push_back(std::abs(state.x.value() - exact));
    }
    // The next term of the error is some per cent of the first one.
    expect_order("the place of 2 kg on 50 N/m with 1 N s/m after a second", errors, 1, 0.1,
                 "Implicit Euler is a method of order 1. A higher order is another method, and a lower one is a "
                 "mistake.");
}

TEST_CASE("the energy that is left after one step", "[task-2][one-step]") {
    for (const auto& c : cases()) {
        const Case free{{c.body.mass, c.body.stiffness, 0.0 * newton_second_per_metre}, c.h};
        const double right = energy_of(free.body, after_steps(free, starts[0], 1)) / energy_of(free.body, starts[0]);
        expect_near(said(free) + ": the part of the energy that is left after it",
                    exercise::energy_factor(free.body, free.h, 1), right, 1e-12 * right,
                    "Seen from the end of the step the method is explicit Euler, backwards: it multiplies the energy "
                    "by 1 + h^2 k / m.");
    }
}

TEST_CASE("every step takes the same part of what is left", "[task-2][every-step]") {
    for (const auto& c : cases()) {
        const double once = exercise::energy_factor(c.body, c.h, 1);
        for (const int steps : {2, 5, 30}) {
            std::ostringstream what;
            what << said(c) << ": the part of the energy that is left after " << steps << " steps";
            expect_agree(what.str(), "yours", exercise::energy_factor(c.body, c.h, steps),
                         "your factor of one step, so many times", std::pow(once, steps), 1e-12 * std::pow(once, steps),
                         "Each step begins with what the one before it has left.");
        }
    }
}

TEST_CASE("before the first step all of the energy is there", "[task-2][before]") {
    for (const auto& c : cases())
        expect_near(said(c) + ": the part of the energy after no step at all", exercise::energy_factor(c.body, c.h, 0),
                    1.0, 1e-15, "Nothing has been taken.");
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    if (task == 2) {
        for (const auto& c : cases())
            for (const int steps : {0, 1, 3}) numbers.push_back(exercise::energy_factor(c.body, c.h, steps));
        return numbers;
    }
    for_each_step([&](const Case& c, const State& start, const std::string&) {
        const State end = exercise::after_a_step(c.body, start, c.h);
        numbers.insert(numbers.end(), {end.x.value(), end.v.value()});
    });
    return numbers;
}
