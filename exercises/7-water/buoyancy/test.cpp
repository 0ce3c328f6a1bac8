// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on buoyancy (notes 7.4).

#include "tools/exercises/expect.hpp"

#include <ansatz/world.hpp>

#include <cmath>
#include <limits>

using namespace ansatz;
using namespace ansatz::workbook;

namespace {

struct Ball {
    double radius, depth;
};
const Ball balls[] = {{0.7, 0.3}, {0.25, 0.4}, {1.3, 0.05}};
std::string said(const Ball& b) {
    std::ostringstream text;
    text << "a ball of radius " << b.radius << " m whose lowest point is " << b.depth << " m deep: what is under water";
    return text.str();
}
auto submerged(const Ball& b) { return exercise::submerged(b.radius * metre, b.depth * metre); }
/// From the areas of thin slices.
double slices(const Ball& b) {
    const double d = std::min(std::max(b.depth, 0.0), 2 * b.radius);
    double sum = 0;
    for (int i = 0; i < 4000; ++i) {
        const double at = d * (i + 0.5) / 4000;
        sum += std::acos(-1.0) * at * (2 * b.radius - at) * d / 4000;
    }
    return sum;
}

struct Body {
    double mass, volume, density, g;
};
const Body bodies[] = {{30, 0.02, 1025, 9.81}, {7, 0.03, 870, 3.7}, {0.4, 0.0005, 13500, 1.6}};
std::string said(const Body& b) {
    std::ostringstream text;
    text << "a body of " << b.mass << " kg, of which " << b.volume << " m^3 are in a liquid of " << b.density
         << " kg/m^3, g = " << b.g << " m/s^2: its acceleration";
    return text.str();
}
auto acceleration(const Body& b) {
    return exercise::acceleration(b.mass * kilogram, b.volume * cubic_metre, b.density * kilogram_per_cubic_metre,
                                  b.g * metre_per_second_squared);
}

exercise::Spring spring(bool broken = false) { return {300.0 * newton_per_metre, 0.6 * metre, broken}; }
const auto exact = 1e-9 * newton;

struct Liquid {
    double density, g;
};
const Liquid liquids[] = {{1025, 9.81}, {870, 3.7}, {13500, 1.6}};
auto pressed_up(exercise::Spring& one, double depth, const Liquid& l) {
    return exercise::pressed_up(one, depth * metre, l.density * kilogram_per_cubic_metre,
                                l.g * metre_per_second_squared);
}
std::string said(const Liquid& l, double depth) {
    std::ostringstream text;
    text << "300 N/m, " << depth << " m deep, breaks at 0.6 m, in a liquid of " << l.density << " kg/m^3, g = " << l.g
         << " m/s^2: what is pressed up";
    return text.str();
}

struct Lift {
    double speed, lift, g;
};
const Lift lifts[] = {{3, 14, 9.81}, {0.7, 4, 3.7}, {5, 9, 1.6}, {2, 9.7, 9.81}, {1.5, 3.7, 3.7}};
std::string said(const Lift& l) {
    std::ostringstream text;
    text << "a lift of " << l.lift << " m/s^2, g = " << l.g << " m/s^2";
    return text.str();
}
auto lifted(const Lift& l, double depth) {
    return exercise::fixed_acceleration(depth * metre, l.lift * metre_per_second_squared,
                                        l.g * metre_per_second_squared);
}
auto deepest(const Lift& l) {
    return exercise::deepest(l.speed * metre_per_second, l.lift * metre_per_second_squared,
                             l.g * metre_per_second_squared);
}

} // namespace

TEST_CASE("a ball is the sum of its slices", "[task-1][slices]") {
    for (const auto& b : balls)
        expect_near(said(b), submerged(b), slices(b) * cubic_metre, 1e-5 * slices(b) * cubic_metre,
                    "What is under water is a cap, and its height is the depth.");
}

TEST_CASE("above the water nothing of it is in it", "[task-1][above]") {
    for (auto b : balls) {
        b.depth = -0.3 * b.radius;
        expect_near(said(b), submerged(b), 0.0 * cubic_metre, 1e-12 * cubic_metre,
                    "A depth may be negative; a volume may not.");
    }
}

TEST_CASE("under the water all of it is in it", "[task-1][under]") {
    for (auto b : balls) {
        const double all = 4.0 / 3 * std::acos(-1.0) * b.radius * b.radius * b.radius;
        for (const double deep : {2.0, 3.5}) {
            b.depth = deep * b.radius;
            expect_near(said(b), submerged(b), all * cubic_metre, 1e-9 * all * cubic_metre,
                        "There is no more of a ball than the ball, however deep it is.");
        }
    }
}

TEST_CASE("the weight of what it displaces, less its own", "[task-2][archimedes]") {
    for (const auto& b : bodies)
        expect_near(said(b), acceleration(b), (b.density * b.volume / b.mass - 1) * b.g * metre_per_second_squared,
                    1e-9 * metre_per_second_squared, "The push is density g V, on the mass of the body.");
}

TEST_CASE("dry, it falls as everything does", "[task-2][dry]") {
    for (auto b : bodies) {
        b.volume = 0;
        expect_near(said(b), acceleration(b), -b.g * metre_per_second_squared, 1e-12 * metre_per_second_squared,
                    "Where nothing is displaced there is gravity alone.");
    }
}

TEST_CASE("what weighs as much as the water that it displaces hangs in it", "[task-2][hangs]") {
    for (auto b : bodies) {
        b.mass = b.density * b.volume;
        expect_near(said(b), acceleration(b), 0.0 * metre_per_second_squared, 1e-9 * metre_per_second_squared,
                    "The push is its weight.");
    }
}

TEST_CASE("the spring pulls by its stiffness for each metre of depth", "[task-3][pulls]") {
    for (const double depth : {0.1, 0.25, 0.55}) {
        auto one = spring();
        std::ostringstream what;
        what << "300 N/m, " << depth << " m deep, breaks at 0.6 m: its pull";
        expect_near(what.str(), exercise::pull(one, depth * metre), 300 * depth * newton, exact,
                    "It is a spring whose end is at the surface.");
        expect(!one.broken, what.str() + ". It is not that deep, and must not be broken.");
    }
}

TEST_CASE("above the surface it is slack, and whole", "[task-3][slack]") {
    for (const double depth : {-0.2, -0.9}) {
        auto one = spring();
        std::ostringstream what;
        what << "300 N/m, " << -depth << " m above the surface, breaks at 0.6 m: its pull";
        expect_near(what.str(), exercise::pull(one, depth * metre), 0.0 * newton, exact,
                    "It holds a body under the surface; it does not pull one down to it.");
        expect(!one.broken, what.str() + ". It is not deep at all, and must not be broken.");
    }
}

TEST_CASE("deeper than its limit it breaks, and stays broken", "[task-3][breaks]") {
    auto one = spring();
    expect_near("300 N/m, 0.7 m deep, breaks at 0.6 m: its pull", exercise::pull(one, 0.7 * metre), 0.0 * newton, exact,
                "A broken spring pulls at nothing.");
    expect(one.broken, "300 N/m, 0.7 m deep, breaks at 0.6 m: it must be broken then.");
    expect_near("the same, and then 0.3 m deep: its pull", exercise::pull(one, 0.3 * metre), 0.0 * newton, exact,
                "It was broken, and does not mend.");
    expect(one.broken, "the same, and then 0.3 m deep: it must be broken still.");
}

TEST_CASE("the water makes room for the weight that hangs on the spring", "[task-4][weight]") {
    for (const auto& l : liquids)
        for (const double depth : {0.1, 0.55}) {
            auto one = spring();
            expect_near(said(l, depth), pressed_up(one, depth, l), 300 * depth / (l.density * l.g) * cubic_metre,
                        1e-12 * cubic_metre, "So much of the liquid weighs as much as the spring pulls.");
        }
}

TEST_CASE("a slack spring presses nothing up", "[task-4][nothing]") {
    for (const auto& l : liquids) {
        auto one = spring();
        expect_near(said(l, -0.4), pressed_up(one, -0.4, l), 0.0 * cubic_metre, 1e-15 * cubic_metre,
                    "Above the surface nothing hangs on it.");
    }
}

TEST_CASE("when it breaks the column is free, and stays free", "[task-4][free]") {
    for (const auto& l : liquids) {
        auto one = spring();
        pressed_up(one, 0.5, l);
        expect_near(said(l, 0.7), pressed_up(one, 0.7, l), 0.0 * cubic_metre, 1e-15 * cubic_metre,
                    "It breaks there, and nothing hangs on the water any more.");
        expect(one.broken, said(l, 0.7) + ". It must be broken then.");
        expect_near(said(l, 0.2) + ", after it was broken", pressed_up(one, 0.2, l), 0.0 * cubic_metre,
                    1e-15 * cubic_metre, "What is free stays free, also where the body comes up again.");
    }
}

TEST_CASE("under the surface it is lifted, wherever it is", "[task-5][lifted]") {
    for (const auto& l : lifts)
        for (const double depth : {0.01, 2.0})
            expect_near(said(l) + ", under the surface", lifted(l, depth), (l.lift - l.g) * metre_per_second_squared,
                        1e-12 * metre_per_second_squared, "Both act, one up and one down, at any depth alike.");
}

TEST_CASE("above the surface it falls", "[task-5][falls]") {
    for (const auto& l : lifts)
        expect_near(said(l) + ", 0.3 m above the surface", lifted(l, -0.3), -l.g * metre_per_second_squared,
                    1e-12 * metre_per_second_squared, "The air lifts nothing.");
}

TEST_CASE("what is lifted by more than gravity turns round where its speed is used up", "[task-6][turns]") {
    for (const auto& l : lifts) {
        if (!(l.lift > l.g)) continue;
        double y = 0, v = -l.speed; // by small steps
        for (const double dt = 1e-5; v < 0; v += dt * (l.lift - l.g)) y += dt * v;
        std::ostringstream text;
        text << said(l) << ", met at " << l.speed << " m/s: how deep it comes";
        expect_near(text.str(), deepest(l), -y * metre, 1e-3 * -y * metre,
                    "It is slowed by the difference of both, until it stands.");
    }
}

TEST_CASE("what is lifted by gravity or less never turns round", "[task-6][sinks]") {
    for (const auto& l : lifts) {
        if (l.lift > l.g) continue;
        const auto d = deepest(l);
        std::ostringstream text;
        text << said(l) << ", met at " << l.speed << " m/s: how deep it comes\n    yours  " << d
             << "\n    right  inf m\nIt sinks on, slower than it would fall, and no depth is the deepest.";
        expect(d == std::numeric_limits<double>::infinity() * metre, text.str());
    }
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    if (task == 1) {
        for (auto b : balls)
            for (const double factor : {1.0, -0.7, 7.3}) {
                numbers.push_back(submerged({b.radius, factor * b.depth}).value());
            }
        numbers.push_back(submerged({0.3, 0.9}).value());
    } else if (task == 2)
        for (const auto& b : bodies) numbers.push_back(acceleration(b).value());
    else if (task == 4)
        for (const auto& l : liquids)
            for (const bool broken : {false, true})
                for (const double depth : {0.3, -0.4, 0.7, 0.2}) {
                    auto one = spring(broken);
                    numbers.push_back(1e3 * pressed_up(one, depth, l).value());
                    numbers.push_back(1e3 * pressed_up(one, 0.5, l).value());
                }
    else if (task == 5)
        for (const auto& l : lifts)
            for (const double depth : {0.2, 1.7, -0.3}) numbers.push_back(lifted(l, depth).value());
    else if (task == 6)
        for (const auto& l : lifts) {
            const double d = deepest(l).value();
            numbers.push_back(std::isinf(d) ? -1 : d);
        }
    else
        for (const bool broken : {false, true})
            for (const double depth : {0.3, -0.7, 0.7, 0.2}) {
                auto one = spring(broken);
                const auto first = exercise::pull(one, depth * metre);
                numbers.push_back(first.value());
                numbers.push_back(exercise::pull(one, 0.5 * metre).value());
                numbers.push_back(one.broken ? 3 : 2);
            }
    return numbers;
}
