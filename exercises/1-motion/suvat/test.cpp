// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on the SUVAT equations (notes 1.5).

#include "tools/exercises/expect.hpp"

#include <ansatz/world.hpp>

using namespace ansatz;
using namespace ansatz::workbook;

namespace {

using Times = std::vector<Quantity<unit::Time>>;

const auto mps = metre_per_second;
const auto mps2 = metre_per_second_squared;

std::string listed(const Times& times) {
    std::ostringstream text;
    text.precision(17);
    if (times.empty()) text << "no time";
    for (const auto& t : times) text << (&t == &times.front() ? "" : " and ") << t;
    return text.str();
}

/// The times at which s is reached must be these, to some roundings: sixteen units in the last place of each.
void expect_times(double s, double u, double a, const Times& right, const char* why) {
    const Times yours = exercise::times_at(s * metre, u * mps, a * mps2);
    bool equal = yours.size() == right.size();
    for (std::size_t i = 0; equal && i < right.size(); ++i)
        equal = abs(yours[i] - right[i]) <= 16 * 2.3e-16 * abs(right[i]);
    std::ostringstream text;
    text << "when it is displaced by " << s << " m, with u = " << u << " m/s and a = " << a << " m/s^2\n    yours  "
         << listed(yours) << "\n    right  " << listed(right) << "\n"
         << why;
    expect(equal, text.str());
}

} // namespace

TEST_CASE("the displacement after a time", "[task-1][displacement]") {
    expect_near("s with u = 3 m/s, a = -2 m/s^2, t = 5 s", exercise::after(3.0 * mps, -2.0 * mps2, 5.0 * second).s,
                -10.0 * metre, 1e-12 * metre,
                "u t for the velocity that it starts with, and a t^2 / 2 for what comes on top: 15 m - 25 m.");
    expect_near("s with u = 0 m/s, a = 2 m/s^2, t = 3 s", exercise::after(0.0 * mps, 2.0 * mps2, 3.0 * second).s,
                9.0 * metre, 1e-12 * metre,
                "From rest it is a t^2 / 2: the mean velocity, half of the final one, times the time.");
}

TEST_CASE("the velocity after a time", "[task-1][velocity]") {
    expect_near("v with u = 3 m/s, a = -2 m/s^2, t = 5 s", exercise::after(3.0 * mps, -2.0 * mps2, 5.0 * second).v,
                -7.0 * mps, 1e-12 * mps, "v = u + a t: what it had, and what came on top.");
}

TEST_CASE("after two times it is where it is after their sum", "[task-1][two-times]") {
    const auto u = 7.0 * mps;
    const auto a = -3.0 * mps2;
    const auto first = exercise::after(u, a, 1.5 * second);
    const auto second_part = exercise::after(first.v, a, 2.5 * second), whole = exercise::after(u, a, 4.0 * second);
    const auto sum = first.s + second_part.s;
    expect_agree("the displacement in 4 s, with u = 7 m/s and a = -3 m/s^2", "yours in one piece", whole.s,
                 "yours of 1.5 s, and of 2.5 s from that v on", sum, 1e-12 * metre,
                 "One motion cut in two is the same motion: s and v must fit together.");
}

TEST_CASE("the displacement from the final velocity", "[task-2][final-velocity]") {
    expect_near("s with v = 6 m/s, a = 2 m/s^2, t = 3 s",
                exercise::displacement_until(6.0 * mps, 2.0 * mps2, 3.0 * second), 9.0 * metre, 1e-12 * metre,
                "It started from rest (v - a t = 0), so that it has come a t^2 / 2 = 9 m. With the final velocity the "
                "sign is a minus.");
    expect_near("s with v = -7 m/s, a = -2 m/s^2, t = 5 s",
                exercise::displacement_until(-7.0 * mps, -2.0 * mps2, 5.0 * second), -10.0 * metre, 1e-12 * metre,
                "It started with 3 m/s; this is the motion of task 1.");
}

TEST_CASE("without acceleration it is v t", "[task-2][uniform]") {
    expect_near("s with v = 4 m/s, a = 0 m/s^2, t = 2.5 s",
                exercise::displacement_until(4.0 * mps, 0.0 * mps2, 2.5 * second), 10.0 * metre, 1e-12 * metre,
                "Nothing changes the velocity, so that it is the final one all the time.");
}

TEST_CASE("a ball passes a window twice", "[task-3][twice]") {
    // s = u t + a t^2 / 2 with whole numbers: 25 m = 30 m/s t - 5 m/s^2 t^2 at 1 s and at 5 s.
    expect_times(25, 30, -10, {1.0 * second, 5.0 * second},
                 "On its way up and on its way down; the earlier comes first.");
    expect_times(-25, -30, 10, {1.0 * second, 5.0 * second},
                 "The same seen upside down; the earlier comes first, whatever the sign of a.");
}

TEST_CASE("a time before the start counts", "[task-3][before]") {
    // 5 m/s t - 5 m/s^2 t^2 = -30 m at -2 s and at 3 s; -5 m/s t - 5 m/s^2 t^2 = -60 m at -4 s and at 3 s.
    expect_times(-30, 5, -10, {-2.0 * second, 3.0 * second},
                 "The parabola goes on to before the start: both roots are motions.");
    expect_times(-60, -5, -10, {-4.0 * second, 3.0 * second},
                 "The parabola goes on to before the start: both roots are motions.");
}

TEST_CASE("without acceleration there is one time", "[task-3][no-acceleration]") {
    expect_times(6, -4, 0, {-1.5 * second}, "Where a is 0 m/s^2 the equation is s = u t; nothing may be divided by a.");
}

TEST_CASE("at the top of its flight there is one time", "[task-3][top]") {
    expect_times(9, 6, -2, {3.0 * second},
                 "It is there for a moment, with the velocity zero: u^2 + 2 a s = 0. One moment, not two.");
}

TEST_CASE("out of reach there is no time", "[task-3][out-of-reach]") {
    expect_times(10, 6, -2, {}, "Its highest point is at 9 m: u^2 + 2 a s is negative, and has no root.");
}

TEST_CASE("a short way of a fast body does not lose its digits", "[task-3][digits]") {
    const auto u = 1000.0 * mps;
    const auto a = -10.0 * mps2;
    for (const double sign : {1.0, -1.0}) {
        const auto s = sign * 0.001 * metre;
        const Times times = exercise::times_at(s, sign * u, sign * a);
        expect(times.size() == 2,
               "when a bullet of 1000 m/s that gravity pulls back is displaced by 1 mm\n    yours  " + listed(times) +
                   "\n    right  two times\nOnce on its way up and once, much later, on its way down.");
        // t = s / u (1 - a s / (2 u^2) + ...), whose next term is 1e-16 of it.
        const auto right = s / (sign * u) * (1.0 - double(a * sign * s / (2.0 * u * u)));
        std::ostringstream text;
        text << "when a bullet with u = " << sign * u << " is displaced by " << s
             << " for the first time, a = " << sign * a << "\n    yours  " << listed({times[0]}) << "\n    right  "
             << listed({right})
             << "\n-u and the root of u^2 + 2 a s are nearly equal here, and their difference has few digits left. "
                "Compute the root\n"
                "that is a sum, and get the other one from their product: t1 t2 = -2 s / a.";
        expect(abs(times[0] - right) <= 1e-14 * right, text.str());
    }
}

std::vector<double> probe(int task) {
    if (task == 1) {
        const auto one = exercise::after(3.0 * mps, -2.0 * mps2, 5.0 * second),
                   other = exercise::after(-1.0 * mps, 4.0 * mps2, 2.0 * second);
        return {one.s.value(), one.v.value(), other.s.value(), other.v.value()};
    }
    if (task == 2)
        return {exercise::displacement_until(6.0 * mps, 1.0 * mps2, 3.0 * second).value(),
                exercise::displacement_until(-7.0 * mps, -1.0 * mps2, 5.0 * second).value()};
    std::vector<double> numbers;
    for (const auto& [s, u, a] : std::vector<std::array<double, 3>>{
             {25, 30, -10}, {-25, -30, 10}, {-30, 5, -10}, {6, -4, 0}, {9, 6, -2}, {10, 6, -2}, {0.001, 1e6, -10}}) {
        const Times times = exercise::times_at(s * metre, u * mps, a * mps2);
        numbers.push_back(double(times.size()));
        for (const auto& t : times) numbers.push_back(t.value());
    }
    return numbers;
}
