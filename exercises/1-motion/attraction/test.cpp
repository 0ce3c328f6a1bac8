// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on attraction (notes 1.9).

#include "tools/exercises/expect.hpp"

#include <ansatz/world.hpp>

using namespace ansatz;
using namespace ansatz::workbook;

namespace {

using exercise::Body;
using Force = VectorQuantity<unit::Force, 3>;
using Vector3 = Vector<double, 3>;

struct Planet {
    const char* name;
    double g, radius; // m/s^2, m
};
const std::vector<Planet> planets{{"the earth", 9.81, 6.371e6}, {"the moon", 1.62, 1.737e6}, {"a pebble", 0.5, 3}};
const double parts[] = {0.25, 1, 2.5, 60}; // heights, in radii

double yours(const Planet& p, double height) {
    return exercise::gravity_at(height * metre, p.g * metre_per_second_squared, p.radius * metre).value();
}
std::string said(const Planet& p, double height) {
    std::ostringstream text;
    text << p.name << ", whose radius is " << p.radius << " m and whose g at the ground is " << p.g << " m/s^2: at "
         << height << " m above it";
    return text.str();
}

/// Two bodies, in an invented nature in which small things attract each other.
struct Two {
    double first, second; // kg
    Vector3 from, to;     // m
    double G, softening;  // m^3/(kg s^2), m
    Two turned() const { return {second, first, to, from, G, softening}; }
    Body one() const { return {first * kilogram, metres(from[0], from[1], from[2])}; }
    Body other() const { return {second * kilogram, metres(to[0], to[1], to[2])}; }
    double distance() const { return (to - from).norm(); }
};
const std::vector<Two> pairs{{3, 50, {0, 0, 0}, {4, 0, 0}, 2, 0.5},
                             {12, 0.5, {1, 2, -2}, {1.5, 0.5, -1}, 3, 0.75},
                             {2, 7, {-3, 1, 0}, {0, -3, 12}, 10, 2},
                             {5, 5, {0, 0.25, 0}, {0.125, 0, 0.25}, 0.5, 0.375}};
auto constant(const Two& t) { return t.G * (cubic_metre / (kilogram * second * second)); }
double energy(const Two& t) {
    return exercise::potential_energy(t.one(), t.other(), constant(t), t.softening * metre).value();
}
Vector3 force(const Two& t) {
    return exercise::force_on_first(t.one(), t.other(), constant(t), t.softening * metre).value();
}
std::string said(const Two& t) {
    std::ostringstream text;
    text << t.first << " kg in (" << t.from.transpose() << ") m, " << t.second << " kg in (" << t.to.transpose()
         << ") m, G = " << t.G << " m^3/(kg s^2), softening " << t.softening << " m";
    return text.str();
}
/// Newton's law, softened: how hard two pull at each other at a distance, and the work of pulling them from there to
/// another distance, in small steps (the rule of the middle).
double pull(const Two& t, double r) {
    return t.G * t.first * t.second * r / std::pow(r * r + t.softening * t.softening, 1.5);
}
double work(const Two& t, double from, double to) {
    constexpr int steps = 20000;
    const double step = (to - from) / steps;
    double sum = 0;
    for (int i = 0; i < steps; ++i) sum += step * pull(t, from + (i + 0.5) * step);
    return sum;
}
Two at(const Two& t, double distance) {
    Two moved = t;
    moved.to = t.from + distance * (t.to - t.from).normalized();
    return moved;
}

} // namespace

TEST_CASE("at the ground it is g", "[task-1][ground]") {
    for (const Planet& p : planets)
        expect_near(said(p, 0) + ", the acceleration in m/s^2", yours(p, 0), p.g, 1e-9 * p.g,
                    "That is where it was measured.");
}

TEST_CASE("close to the ground it falls by 2 h / R", "[task-1][near]") {
    for (const Planet& p : planets)
        for (const double part : {1e-4, 1e-3, 1e-2})
            expect_near(said(p, part * p.radius) + ", the acceleration in m/s^2", yours(p, part * p.radius),
                        p.g * (1 - 2 * part), 4 * p.g * part * part,
                        "1 / (1 + h/R)^2 is about 1 - 2 h/R, for a small h/R.");
}

TEST_CASE("with the square of the distance from the centre it falls", "[task-1][far]") {
    for (const Planet& p : planets)
        for (const double part : parts)
            expect_near(said(p, part * p.radius) + ", the acceleration in m/s^2", yours(p, part * p.radius),
                        p.g / ((1 + part) * (1 + part)), 1e-9 * p.g,
                        "Twice as far from the centre there is a quarter left; and at the ground one is a radius away "
                        "from it.");
}

TEST_CASE("what it rises by is the work of pulling them apart", "[task-2][work]") {
    for (const Two& t : pairs)
        for (const auto& [from, to] : {std::pair{0.5, 1.0}, {1.0, 4.0}, {2.0, 9.0}}) {
            std::ostringstream what;
            what << said(t) << ": by how much the energy rises, in J, from a distance of " << from << " m to " << to
                 << " m";
            const double right = work(t, from, to);
            expect_near(what.str(), energy(at(t, to)) - energy(at(t, from)), right, 1e-6 * right,
                        "Right is the sum of many small steps of the pull times the way, against the pull.");
        }
}

TEST_CASE("far apart they hold nothing, and nearer less than nothing", "[task-2][far-apart]") {
    for (const Two& t : pairs) {
        expect_near(said(at(t, 1e12)) + ": the energy in J", energy(at(t, 1e12)), 0.0, 1e-8,
                    "Nobody gains anything by being still farther apart: that is where it is counted from.");
        std::ostringstream text;
        text << said(t) << ": the energy\n    yours  " << energy(t)
             << " J\nWho takes them apart has to put in work, until nothing is left: so it was less than nothing.";
        expect(energy(t) < 0, text.str());
    }
}

TEST_CASE("where they meet the softening keeps it finite", "[task-2][meeting]") {
    for (const Two& t : pairs) {
        const Two met = at(t, 0);
        expect_near(said(met) + ": the energy in J", energy(met), -t.G * t.first * t.second / t.softening,
                    1e-9 * t.G * t.first * t.second / t.softening,
                    "There r is zero, and what is left of the root is epsilon.");
    }
}

TEST_CASE("the first is pulled to where the second is", "[task-3][towards]") {
    for (const Two& t : pairs) {
        std::ostringstream text;
        text << said(t) << ": the force on the first\n    yours  (" << force(t).transpose()
             << ") N\nIt is attracted: the force points to the second.";
        expect(force(t).dot(t.to - t.from) > 0, text.str());
    }
}

TEST_CASE("along each axis the force is how fast the energy falls", "[task-3][energy-falls]") {
    for (const Two& t : pairs) {
        auto reference = [&](const Vector3& from) {
            return -t.G * t.first * t.second / std::hypot((t.to - from).norm(), t.softening);
        };
        const double h = 1e-5;
        Vector3 right;
        for (int k = 0; k < 3; ++k) {
            Vector3 by = Vector3::Zero();
            by[k] = h;
            right[k] = -(reference(t.from + by) - reference(t.from - by)) / (2 * h);
        }
        expect_near(
            said(t) + ": the force on the first", Force::from_value(force(t)), Force::from_value(right),
            1e-5 * right.norm() * newton,
            "Right was found by moving the first a little along each axis: whoever follows this force gains what "
            "the energy loses.");
    }
}

TEST_CASE("what the second feels is the opposite", "[task-3][third-law]") {
    for (const Two& t : pairs) {
        const Vector3 back = -force(t.turned());
        expect_agree(said(t), "yours, on the first", Force::from_value(force(t)), "yours, on the second, turned round",
                     Force::from_value(back), 1e-9 * force(t).norm() * newton,
                     "Newton's third law: the pull is the same at both ends, however different the masses.");
    }
}

TEST_CASE("where they meet there is no force", "[task-3][meeting-force]") {
    for (const Two& t : pairs) {
        const Two close = at(t, 1e-8 * t.softening);
        expect_near(said(close) + ": the force on the first", Force::from_value(force(close)),
                    Force::from_value(Vector3(Vector3::Zero())), 1e-5 * pull(t, t.softening) * newton,
                    "The energy is flat there: the softened pull grows with r first, and falls with r^2 only beyond "
                    "epsilon.");
    }
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    if (task == 1)
        for (const Planet& p : planets)
            for (const double part : parts) numbers.push_back(yours(p, part * p.radius));
    for (const Two& t : pairs) {
        if (task == 2) numbers.push_back(energy(t)), numbers.push_back(energy(at(t, 0.3)));
        if (task == 3)
            for (int k = 0; k < 3; ++k) numbers.push_back(force(t)[k]);
    }
    return numbers;
}
