// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on two bodies and a spring (notes 3).

#include "tools/exercises/expect.hpp"

#include <ansatz/world.hpp>

#include <numbers>

using namespace ansatz;
using namespace ansatz::workbook;

namespace {

using exercise::Body;
using exercise::Pair;
using Time = Quantity<unit::Time>;
using Length = Quantity<unit::Length>;
using Velocity = Quantity<unit::Velocity>;
using PerMetre = Quantity<unit::Stiffness>;

struct Swing {
    double first, second, stiffness; // kg, kg, N/m
    double omega() const { return std::sqrt(stiffness / first + stiffness / second); }
    double period() const { return 2 * std::numbers::pi / omega(); }
};
const std::vector<Swing> swings{{1, 3, 100}, {5, 0.5, 40}, {0.25, 0.75, 3}, {70, 1200, 9000}};
Time yours(const Swing& s) {
    return exercise::period(s.first * kilogram, s.second * kilogram, s.stiffness * newton_per_metre);
}
std::string said(const Swing& s) {
    std::ostringstream text;
    text << s.first << " kg and " << s.second << " kg on a spring of " << s.stiffness << " N/m: one swing";
    return text.str();
}
/// Let go from a stretch, the spring passes its rest length after a quarter of a swing; found in small steps (velocity
/// Verlet), of the two bodies and not of what they have between them.
double followed(const Swing& s) {
    const double dt = 1e-3 * std::sqrt(std::min(s.first, s.second) / s.stiffness);
    double a = 0, b = 1, u = 0, v = 0, t = 0, before = 1; // the rest length is left out: b - a is the stretch
    auto kick = [&] { u += s.stiffness * (b - a) / s.first * dt / 2, v -= s.stiffness * (b - a) / s.second * dt / 2; };
    while (b - a > 0) {
        before = b - a;
        kick(), a += u * dt, b += v * dt, kick();
        t += dt;
    }
    return 4 * (t - dt + dt * before / (before - (b - a)));
}

using SideBySide = std::vector<PerMetre>;
const std::vector<SideBySide> sets{
    {200.0 * newton_per_metre, 50.0 * newton_per_metre},
    {30.0 * newton_per_metre, 70.0 * newton_per_metre, 400.0 * newton_per_metre},
    {8.0 * newton_per_metre, 1.5 * newton_per_metre, 2.5 * newton_per_metre, 90.0 * newton_per_metre}};
std::string said(const SideBySide& springs) {
    std::ostringstream text;
    text << "springs of";
    for (const char* between = " "; const PerMetre& k : springs) text << between << k.value(), between = ", ";
    text << " N/m";
    return text.str();
}

Body body(double mass, double place, double speed) {
    return {mass * kilogram, place * metre, speed * metre_per_second};
}
const std::vector<Pair> pairs{{body(1, 0, 0.5), body(3, 1.4, 0), 100.0 * newton_per_metre, 1.0 * metre},
                              {body(5, -3, -2), body(0.5, -0.75, 1), 40.0 * newton_per_metre, 2.5 * metre},
                              {body(0.25, 7, 1.5), body(0.75, 8.5, 2.25), 3.0 * newton_per_metre, 1.25 * metre},
                              {body(70, -20, 3), body(1200, -16.5, -0.25), 9000.0 * newton_per_metre, 4.0 * metre}};
Swing swing_of(const Pair& p) { return {p.first.mass.value(), p.second.mass.value(), p.stiffness.value()}; }
const double parts[] = {0.125, 0.4, 0.75, 1.7}; // of a swing
Time part_of(const Pair& p, double part) { return part * swing_of(p).period() * second; }
Pair then(const Pair& p, Time time) { return exercise::after(p, time); }
std::string said(const Pair& p) {
    std::ostringstream text;
    auto one = [&](const Body& b) { text << b.mass << " at " << b.place << " with " << b.velocity; };
    one(p.first), text << ", ", one(p.second);
    text << ", a spring of " << p.stiffness << " that is " << p.rest_length << " long at rest";
    return text.str();
}
std::string said(const Pair& p, Time time) {
    std::ostringstream text;
    text << said(p) << "; after " << time << ", ";
    return text.str();
}
auto momentum(const Pair& p) { return p.first.mass * p.first.velocity + p.second.mass * p.second.velocity; }
Length centre(const Pair& p) {
    return (p.first.mass * p.first.place + p.second.mass * p.second.place) / (p.first.mass + p.second.mass);
}
double energy(const Pair& p) {
    auto moving = [](const Body& b) { return 0.5 * b.mass.value() * b.velocity.value() * b.velocity.value(); };
    const double x = (p.second.place - p.first.place - p.rest_length).value();
    return moving(p.first) + moving(p.second) + 0.5 * p.stiffness.value() * x * x;
}
/// The same in small steps.
Pair stepped(const Pair& p, Time time) {
    const double m = p.first.mass.value(), n = p.second.mass.value(), k = p.stiffness.value();
    double a = p.first.place.value(), b = p.second.place.value();
    double u = p.first.velocity.value(), v = p.second.velocity.value();
    const int steps = 20000;
    const double dt = time.value() / steps;
    auto kick = [&] {
        const double pull = k * (b - a - p.rest_length.value());
        u += pull / m * dt / 2, v -= pull / n * dt / 2;
    };
    for (int i = 0; i < steps; ++i) kick(), a += u * dt, b += v * dt, kick();
    return {body(m, a, u), body(n, b, v), p.stiffness, p.rest_length};
}
void expect_same(const std::string& what, const Pair& yours, const Pair& right, double tolerance, const char* why) {
    const Length places = tolerance * metre;
    const Velocity speeds = tolerance * swing_of(right).omega() * metre_per_second;
    expect_near(what + "the place of the first", yours.first.place, right.first.place, places, why);
    expect_near(what + "the place of the second", yours.second.place, right.second.place, places, why);
    expect_near(what + "the velocity of the first", yours.first.velocity, right.first.velocity, speeds, why);
    expect_near(what + "the velocity of the second", yours.second.velocity, right.second.velocity, speeds, why);
}

} // namespace

TEST_CASE("a pair swings as two bodies do that are followed in steps", "[task-1][followed]") {
    for (const Swing& s : swings)
        expect_near(
            said(s), yours(s), followed(s) * second, 1e-5 * s.period() * second,
            "Right is what small steps of both bodies found. Both move, so that the spring is relaxed sooner than "
            "if one were held.");
}

TEST_CASE("beside a mountain it swings as at a wall", "[task-1][mountain]") {
    for (const Swing& s : swings) {
        const double right = 2 * std::numbers::pi * std::sqrt(s.first / s.stiffness);
        for (const Swing& mountain : {Swing{s.first, 1e12, s.stiffness}, Swing{1e12, s.first, s.stiffness}})
            expect_near(said(mountain), yours(mountain), right * second, 1e-9 * right * second,
                        "What is so heavy does not move. Only the other one swings: 2 pi times the root of its m / k.");
    }
}

TEST_CASE("two of one mass swing as one of them on half of the spring", "[task-1][equal]") {
    for (const Swing& s : swings) {
        const Swing twins{s.first, s.first, s.stiffness};
        const double right = 2 * std::numbers::pi * std::sqrt(s.first / (2 * s.stiffness));
        expect_near(
            said(twins), yours(twins), right * second, 1e-9 * right * second,
            "The middle of the spring stands still between two equal bodies, so that each has half of the spring, "
            "and that is twice as stiff: 2 pi times the root of m / (2 k).");
    }
}

TEST_CASE("beside each other springs add their forces", "[task-2][beside]") {
    for (const SideBySide& springs : sets) {
        double right = 0;
        for (const PerMetre& k : springs) right += k.value();
        expect_near(said(springs) + " beside each other: as stiff as one of", exercise::beside(springs),
                    right * newton_per_metre, 1e-9 * right * newton_per_metre,
                    "Make all of them longer by a metre: each pulls with its own k, and you feel all of them.");
    }
}

TEST_CASE("in a row springs add their stretches", "[task-2][row]") {
    for (const SideBySide& springs : sets) {
        double stretch = 0; // under one newton
        for (const PerMetre& k : springs) stretch += 1 / k.value();
        std::ostringstream why;
        why << "Pull with 1 N: every spring carries it, and each is stretched by 1 N / k, in all by " << stretch
            << " m.";
        expect_near(said(springs) + " in a row: as stiff as one of", exercise::in_a_row(springs),
                    1 / stretch * newton_per_metre, 1e-9 / stretch * newton_per_metre, why.str());
    }
}

TEST_CASE("a spring cut into equal parts is their row again", "[task-2][cut]") {
    for (const int parts : {1, 2, 5, 12}) {
        const SideBySide springs(static_cast<std::size_t>(parts), double(parts) * 60.0 * newton_per_metre);
        std::ostringstream text;
        text << "a spring of 60 N/m in " << parts << " equal parts, each of " << springs[0] << ": the row of them";
        expect_near(text.str(), exercise::in_a_row(springs), 60.0 * newton_per_metre, 1e-7 * newton_per_metre,
                    "A part is as many times stiffer as there are parts, and their row is the spring from which they "
                    "were cut.");
    }
}

TEST_CASE("after no time they are where they were", "[task-3][now]") {
    for (const Pair& p : pairs)
        expect_same(
            said(p, 0.0 * second), then(p, 0.0 * second), p, 1e-9,
            "Nothing has happened yet. Does your way back lead to the places from which you took the centre and "
            "the length?");
}

TEST_CASE("the momentum stays what it was", "[task-3][momentum]") {
    for (const Pair& p : pairs)
        for (const double part : parts) {
            const Time time = part_of(p, part);
            expect_near(said(p, time) + "the momentum of both", momentum(then(p, time)), momentum(p),
                        1e-9 * (p.first.mass + p.second.mass) * metre_per_second,
                        "The spring gives to one what it takes from the other, and nothing acts from outside.");
        }
}

TEST_CASE("the centre of mass goes straight on", "[task-3][centre]") {
    for (const Pair& p : pairs)
        for (const double part : parts) {
            const Time time = part_of(p, part);
            const Length right = centre(p) + momentum(p) / (p.first.mass + p.second.mass) * time;
            expect_near(said(p, time) + "the centre of mass", centre(then(p, time)), right, 1e-9 * metre,
                        "It begins at (m x + M X) / (m + M) and goes with (m v + M V) / (m + M), whatever the spring "
                        "does.");
        }
}

TEST_CASE("the energy stays what it was", "[task-3][energy]") {
    for (const Pair& p : pairs)
        for (const double part : parts) {
            const Time time = part_of(p, part);
            expect_near(
                said(p, time) + "the energy in J", energy(then(p, time)), energy(p), 1e-6 * energy(p),
                "m v^2 / 2 of each, and k x^2 / 2 of the spring, x being the length less the rest length. Without "
                "damping none of it is lost.");
        }
}

TEST_CASE("after a whole swing the spring is as it was", "[task-3][whole-swing]") {
    for (const Pair& p : pairs)
        for (const int whole : {1, 3}) {
            const Time time = part_of(p, whole);
            const Pair late = then(p, time);
            expect_near(said(p, time) + (whole == 1 ? "one whole swing" : "three whole swings") + ", its length",
                        late.second.place - late.first.place, p.second.place - p.first.place, 1e-5 * metre,
                        "The pair has flown on, but the two are as far apart as in the beginning.");
        }
}

TEST_CASE("where they are is where small steps lead", "[task-3][stepped]") {
    for (const Pair& p : pairs)
        for (const double part : parts) {
            const Time time = part_of(p, part);
            expect_same(said(p, time), then(p, time), stepped(p, time), 1e-5, "Right is what 20000 small steps found.");
        }
}

TEST_CASE("two times one after the other are their sum", "[task-3][in-parts]") {
    for (const Pair& p : pairs) {
        const Time one = part_of(p, 0.3), other = part_of(p, 0.55);
        const Pair parts = then(then(p, one), other), whole = then(p, one + other);
        std::ostringstream what;
        what << said(p) << "; after " << one << " and then " << other << " more, ";
        expect_same(
            what.str(), parts, whole, 1e-5,
            "Yours is what your function makes of its own result; right is what it says of both times at once. The "
            "velocities must be those of the new moment.");
    }
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    if (task == 1)
        for (const Swing& s : swings) numbers.push_back(yours(s).value());
    if (task == 2)
        for (const SideBySide& springs : sets) {
            numbers.push_back(exercise::beside(springs).value());
            numbers.push_back(exercise::in_a_row(springs).value());
        }
    if (task == 3)
        for (const Pair& p : pairs)
            for (const double part : {0.4, 1.7}) {
                const Pair late = then(p, part_of(p, part));
                for (const Body& b : {late.first, late.second})
                    numbers.push_back(b.place.value()), numbers.push_back(b.velocity.value());
            }
    return numbers;
}
