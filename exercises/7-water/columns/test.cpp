// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on columns of water (notes 7.2).

#include "tools/exercises/expect.hpp"

#include <ansatz/world.hpp>

#include <cmath>

using namespace ansatz;
using namespace ansatz::workbook;

namespace {

using Length = Quantity<unit::Length>;

struct Column {
    double height, dx, dz;
};
const Column columns[] = {{3, 1, 2}, {0.7, 0.4, 0.25}, {5, 2.5, 0.3}};

std::string said(const Column& c) {
    std::ostringstream text;
    text << "a column " << c.height << " m high that stands on " << c.dx << " m by " << c.dz << " m";
    return text.str();
}
auto volume(const Column& c) { return exercise::volume(c.height * metre, c.dx * metre, c.dz * metre); }

/// Heights around one of 1.3 m.
struct Scene {
    double west, east, south, north, rate, c, width, dt;
    auto answer() const {
        const exercise::Neighbours around{west * metre, east * metre, south * metre, north * metre};
        return exercise::next_rate(rate * metre_per_second, 1.3 * metre, around, c * metre_per_second, width * metre,
                                   dt * second);
    }
};
const Scene scenes[] = {{1.5, 1.2, 1.9, 1.1, 0.3, 2, 0.5, 0.02}, {1.0, 1.4, 1.25, 0.6, -0.7, 3, 0.8, 0.05}};
std::string said(const Scene& s) {
    std::ostringstream text;
    text << "a column of 1.3 m that rises at " << s.rate << " m/s between " << s.west << ", " << s.east << ", "
         << s.south << " and " << s.north << " m, " << s.width << " m wide, waves at " << s.c << " m/s, a step of "
         << s.dt << " s: its rate";
    return text.str();
}

/// The growth of a chessboard of columns in that many steps, by its own recurrence.
double growth(double c, double dx, double dz, double dt, int steps) {
    const double stiffness = c * c * (4 / (dx * dx) + 4 / (dz * dz));
    double height = 1, rate = 0, most = 1;
    for (int n = 0; n < steps && most < 1e9; ++n) {
        rate -= dt * stiffness * height;
        height += dt * rate;
        most = std::max(most, std::abs(height));
    }
    return most;
}
const double grids[][3] = {{2, 0.5, 0.5}, {3, 1, 0.4}, {0.7, 0.3, 1.1}}; // c, dx, dz
auto step_of(const double (&g)[3]) {
    return exercise::longest_step(g[0] * metre_per_second, g[1] * metre, g[2] * metre);
}

/// Damped for a time, in so many steps.
struct Fading {
    double rate, damping, time;
    Quantity<unit::Velocity> after(int steps) const {
        auto v = rate * metre_per_second;
        for (int n = 0; n < steps; ++n) v = exercise::damped(v, damping / second, time / steps * second);
        return v;
    }
    Quantity<unit::Velocity> right() const { return rate * std::exp(-damping * time) * metre_per_second; }
};
const Fading fading[] = {{0.8, 0.7, 1}, {-1.3, 2.3, 1}, {0.4, 5, 0.6}};
std::string said(const Fading& f, int steps) {
    std::ostringstream text;
    text << "a rate of " << f.rate << " m/s, damped by " << f.damping << " 1/s for " << f.time << " s in " << steps
         << (steps == 1 ? " step" : " steps");
    return text.str();
}

} // namespace

TEST_CASE("a column holds height times footprint", "[task-1][volume]") {
    for (const auto& c : columns)
        expect_near(said(c) + ": what it holds", volume(c), c.height * c.dx * c.dz * cubic_metre, 1e-12 * cubic_metre,
                    "The footprint lies in the plane of x and z; the height is over it.");
}

TEST_CASE("twice as high, it holds twice as much", "[task-1][twice]") {
    for (auto c : columns) {
        const auto once = volume(c);
        c.height *= 2;
        expect_agree(said(c) + ", and half of that", "yours, two times the half", 2.0 * once, "yours, of all",
                     volume(c), 1e-12 * abs(once),
                     "Water that is poured on top of as much water makes twice the water.");
    }
}

TEST_CASE("level water stays as it moves", "[task-2][level]") {
    for (auto s : scenes) {
        s.west = s.east = s.south = s.north = 1.3;
        expect_near(said(s), s.answer(), s.rate * metre_per_second, 1e-12 * metre_per_second,
                    "Nobody pulls where all heights are the same: the rate stays what it was.");
    }
}

TEST_CASE("a column between higher ones is pulled up", "[task-2][up]") {
    for (auto s : scenes) {
        s.west = s.east = s.south = s.north = 1.5;
        const auto rate = s.answer();
        expect(is_finite(rate) && rate > s.rate * metre_per_second,
               said(s) + ". It is lower than all of its neighbours, and must rise faster than before.");
    }
}

TEST_CASE("each neighbour pulls as the wave equation says", "[task-2][pull]") {
    for (const auto& s : scenes) {
        const double by = s.c * s.c / (s.width * s.width) * s.dt;
        const double right =
            s.rate + by * (s.west - 1.3) + by * (s.east - 1.3) + by * (s.south - 1.3) + by * (s.north - 1.3);
        expect_near(said(s), s.answer(), right * metre_per_second, 1e-12 * metre_per_second,
                    "Each of the four pulls by its difference, times c^2 over the width squared, for a time of dt.");
    }
}

TEST_CASE("a step a hair shorter stays", "[task-3][stays]") {
    for (const auto& g : grids) {
        const auto dt = step_of(g);
        std::ostringstream text;
        text << "columns of " << g[1] << " m by " << g[2] << " m, waves at " << g[0] << " m/s\n    yours  " << dt
             << "\nWith 0.999 of that a chessboard of columns grows without end.";
        expect(is_finite(dt) && dt > 0.0 * second && growth(g[0], g[1], g[2], 0.999 * dt.value(), 5000) < 1000,
               text.str());
    }
}

TEST_CASE("a step a hair longer explodes", "[task-3][explodes]") {
    for (const auto& g : grids) {
        const auto dt = step_of(g);
        std::ostringstream text;
        text << "columns of " << g[1] << " m by " << g[2] << " m, waves at " << g[0] << " m/s\n    yours  " << dt
             << "\nIt is stable, but not the longest: with 1.01 of it a chessboard of columns does not grow yet.";
        expect(is_finite(dt) && growth(g[0], g[1], g[2], 1.01 * dt.value(), 5000) > 1e6, text.str());
    }
}

TEST_CASE("after a second it is the same at every frame rate", "[task-4][rates]") {
    for (const auto& f : fading)
        for (const int steps : {5, 30, 240})
            expect_near(said(f, steps), f.after(steps), f.right(), 1e-12 * metre_per_second,
                        "What is lost per second is lost in a second, however many frames it has.");
}

TEST_CASE("two halves of a step leave what the step does", "[task-4][halves]") {
    for (const auto& f : fading)
        expect_agree(said(f, 2), "yours, in one step", f.after(1), "yours, in two", f.after(2),
                     1e-12 * metre_per_second, "A time may be cut into steps as one likes.");
}

TEST_CASE("however strong it is, it turns no column round", "[task-4][strong]") {
    for (auto f : fading) {
        f.damping = 40;
        const auto left = f.after(1);
        expect(is_finite(left) && left / (f.rate * metre_per_second) >= 0.0 && abs(left) < 0.1 * metre_per_second,
               said(f, 1) + ". It has almost stopped, and moves as before: it must neither turn round nor grow.");
    }
}

TEST_CASE("without damping nothing is lost", "[task-4][none]") {
    for (auto f : fading) {
        f.damping = 0;
        expect_near(said(f, 3), f.after(3), f.rate * metre_per_second, 1e-14 * metre_per_second,
                    "Nothing takes from it.");
    }
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    if (task == 1)
        for (const auto& c : columns) numbers.push_back(volume(c).value());
    else if (task == 2)
        for (const auto& s : scenes) numbers.push_back(s.answer().value());
    else if (task == 3)
        for (const auto& g : grids) numbers.push_back(step_of(g).value());
    else
        for (const auto& f : fading)
            for (const int steps : {1, 3}) numbers.push_back(f.after(steps).value());
    return numbers;
}
