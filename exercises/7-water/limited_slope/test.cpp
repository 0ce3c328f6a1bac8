// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on a slope that makes no new crest (notes 7.2).

#include "tools/exercises/expect.hpp"

#include <ansatz/world.hpp>

#include <algorithm>
#include <cmath>
#include <random>

using namespace ansatz;
using namespace ansatz::workbook;

namespace {

const double g = 3.7; // m/s^2
const auto push_unit = square_metre * metre_per_second_squared;

struct Three {
    double west, here, east; // m
    double steepness;
};
/// Up and down, with each of the three candidates the smallest once, and steepnesses between the ends.
const Three rising[] = {{0.3, 0.7, 1.2, 1.7}, {0.2, 0.9, 1.1, 1.3}, {-0.4, -0.3, 1.9, 1.6}, {0.5, 1.8, 1.9, 2}};
const Three turning[] = {{0.3, 1.4, 0.8, 1.7}, {1.2, 0.4, 0.9, 1.3}, {0.6, 0.6, 1.7, 1.8}, {0.5, 1.3, 1.3, 1.2}};

Three turned(const Three& t) { return {t.east, t.here, t.west, t.steepness}; }
std::string said(const Three& t) {
    std::ostringstream text;
    text << t.west << " m, " << t.here << " m, " << t.east << " m, steepness " << t.steepness;
    return text.str();
}
double rise(const Three& t) {
    return exercise::half_rise(t.west * metre, t.here * metre, t.east * metre, t.steepness).value();
}
/// The largest part of the slope through both neighbours that neither difference forbids, by bisection.
double largest(const Three& t) {
    const double middle = (t.east - t.west) / 4;
    double none = 0, all = 1;
    for (int n = 0; n < 60; ++n) {
        const double part = n == 0 ? 1 : (none + all) / 2, half = std::abs(part * middle);
        const bool allowed =
            half <= t.steepness / 2 * std::abs(t.here - t.west) && half <= t.steepness / 2 * std::abs(t.east - t.here);
        if (n == 0 && allowed) return middle;
        (allowed ? none : all) = part;
    }
    return none * middle;
}

struct Ground {
    double bed, height;
    exercise::Column column() const { return {bed * metre, height * metre}; }
    double level() const { return bed + height; }
};
struct Neighbours {
    Ground west, here, east;
    double steepness;
};
const Neighbours rows[] = {{{0.2, 1.3}, {0.5, 1.1}, {0.9, 0.4}, 1.7},
                           {{0.9, 0.3}, {0.4, 0.6}, {0.1, 1.6}, 1.4},
                           {{-0.3, 0.8}, {0.2, 0.7}, {0.4, 0.2}, 1.9}};
exercise::Column west_end(const Neighbours& r) {
    return exercise::west_end(r.west.column(), r.here.column(), r.east.column(), r.steepness);
}
exercise::Column east_end(const Neighbours& r) {
    return exercise::east_end(r.west.column(), r.here.column(), r.east.column(), r.steepness);
}
std::string said(const Neighbours& r) {
    std::ostringstream text;
    text << "beds of " << r.west.bed << ", " << r.here.bed << " and " << r.east.bed << " m, heights of "
         << r.west.height << ", " << r.here.height << " and " << r.east.height << " m, steepness " << r.steepness;
    return text.str();
}
double pushed(const Ground& w, const Ground& e) {
    return exercise::pushed(w.column(), e.column(), g * metre_per_second_squared).value();
}
struct Ends {
    Ground west, east;
};
const Ends ends[] = {{{0.2, 1.3}, {0.5, 0.7}}, {{0.8, 0.4}, {0.1, 0.9}}, {{-0.3, 1.1}, {-0.6, 1.7}}};

} // namespace

TEST_CASE("a line stays a line", "[task-1][line]") {
    for (const double steepness : {1.0, 1.4, 2.0}) {
        const Three up{0.4, 0.7, 1.0, steepness};
        expect_near(said(up) + ": half of the rise", rise(up), 0.15, 1e-12,
                    "From its middle to its face is half a column; between both neighbours are two.");
        expect_near(said(turned(up)) + ": half of the rise", rise(turned(up)), -0.15, 1e-12,
                    "Down it is what up is, with the other sign.");
    }
}

TEST_CASE("as steep as the neighbours allow", "[task-1][steep]") {
    for (const Three& t : rising)
        for (const Three& one : {t, turned(t)})
            expect_near(said(one) + ": half of the rise", rise(one), largest(one), 1e-9,
                        "It is a quarter of the difference between both neighbours, or as much of that as both "
                        "differences, times steepness / 2, allow.");
}

TEST_CASE("a crest, a trough and the edge of a plain are level", "[task-1][crest]") {
    for (const Three& t : turning)
        expect_near(said(t) + ": half of the rise", rise(t), 0.0, 1e-12,
                    "Any slope would stand above the crest at one face, or below the trough.");
}

TEST_CASE("no face is higher or lower than both columns beside it", "[task-1][between]") {
    std::mt19937 dice(7);
    std::uniform_real_distribution<double> height(-1, 2), steepness(1, 2);
    for (int n = 0; n < 2000; ++n) {
        const Three t{height(dice), height(dice), height(dice), steepness(dice)};
        const double half = rise(t), at_west = t.here - half, at_east = t.here + half;
        std::ostringstream text;
        text << said(t) << ": at its faces " << at_west << " m and " << at_east
             << " m.\nEach must be between the two columns beside it.";
        expect(at_west >= std::min(t.west, t.here) - 1e-12 && at_west <= std::max(t.west, t.here) + 1e-12 &&
                   at_east >= std::min(t.east, t.here) - 1e-12 && at_east <= std::max(t.east, t.here) + 1e-12,
               text.str());
    }
}

TEST_CASE("of a smooth wave it is of second order", "[task-1][order]") {
    std::vector<double> errors;
    for (const double width : {0.04, 0.02, 0.01, 0.005}) {
        auto mean = [&](double x) { return (std::cos(x - width / 2) - std::cos(x + width / 2)) / width; };
        const double half = rise({mean(0.6 - width), mean(0.6), mean(0.6 + width), 1.5});
        errors.push_back(std::abs(mean(0.6) + half - std::sin(0.6 + width / 2)));
    }
    expect_order(
        "What a sine has at a face, from the means of three columns", errors, 2, 0.1,
        "Where the wave neither turns nor bends much, nothing is limited, and a line is right but for its bend.");
}

TEST_CASE("level and height are lines", "[task-2][lines]") {
    for (const Neighbours& r : rows) {
        const auto w = west_end(r), e = east_end(r);
        const double height = rise({r.west.height, r.here.height, r.east.height, r.steepness}),
                     surface = rise({r.west.level(), r.here.level(), r.east.level(), r.steepness});
        expect_near(said(r) + ": the height at the western face", w.height, (r.here.height - height) * metre,
                    1e-12 * metre, "From the middle to the west a line falls by what it rises to the east.");
        expect_near(said(r) + ": the height at the eastern face", e.height, (r.here.height + height) * metre,
                    1e-12 * metre, "The height of the column and half of its rise.");
        expect_near(said(r) + ": the level at the western face", level(w), (r.here.level() - surface) * metre,
                    1e-12 * metre, "The level is a line of its own; the bed is what is left.");
        expect_near(said(r) + ": the level at the eastern face", level(e), (r.here.level() + surface) * metre,
                    1e-12 * metre, "The level is a line of its own; the bed is what is left.");
    }
}

TEST_CASE("a lake is level at all faces", "[task-2][lake]") {
    const Neighbours shore{{0.2, 1.0}, {0.7, 0.5}, {1.6, 0}, 1.6};
    for (const Neighbours& r : {Neighbours{{0.2, 1.0}, {0.7, 0.5}, {0.4, 0.8}, 1.6},
                                Neighbours{{0.1, 1.1}, {0.3, 0.9}, {1.0, 0.2}, 1.3}, shore}) {
        expect_near(said(r) + ": the level at the western face", level(west_end(r)), 1.2 * metre, 1e-12 * metre,
                    "The column and one neighbour have one level; so have the faces, whatever the beds do.");
        expect_near(said(r) + ": the level at the eastern face", level(east_end(r)), 1.2 * metre, 1e-12 * metre,
                    "The column and one neighbour have one level; so have the faces, whatever the beds do.");
    }
}

TEST_CASE("no height is negative, and both ends have the water of the column", "[task-2][water]") {
    std::mt19937 dice(11);
    std::uniform_real_distribution<double> bed(-1, 2), height(0, 1.5), steepness(1, 2);
    for (int n = 0; n < 500; ++n) {
        auto one = [&] { return Ground{bed(dice), n % 3 == 0 && height(dice) < 0.5 ? 0.0 : height(dice)}; };
        const Neighbours r{one(), one(), one(), steepness(dice)};
        const auto w = west_end(r), e = east_end(r);
        std::ostringstream text;
        text << said(r) << ": at the faces the water is " << w.height << " and " << e.height
             << " high.\nHeights are never negative: they are lines with a limit, and the bed gives way.";
        expect(w.height >= -1e-12 * metre && e.height >= -1e-12 * metre, text.str());
        expect_near(said(r) + ": the mean of both heights", 0.5 * (w.height + e.height), r.here.height * metre,
                    1e-12 * metre, "A line through the middle: neither more water nor less.");
    }
}

TEST_CASE("over level ground the pressure pushes", "[task-3][pressure]") {
    for (const Ends& p : ends) {
        const double w = p.west.height, e = p.east.height;
        expect_near("heights of " + std::to_string(w) + " and " + std::to_string(e) + " m over level ground",
                    pushed({0.4, w}, {0.4, e}) * push_unit, g * (w * w - e * e) / 2 * push_unit, 1e-9 * push_unit,
                    "Eastwards what presses at the western end, less what presses at the eastern one.");
    }
}

TEST_CASE("water of one height is pushed down the slope by its weight", "[task-3][slope]") {
    for (const Ends& p : ends)
        expect_near(
            "1.3 m of water over a bed from " + std::to_string(p.west.bed) + " to " + std::to_string(p.east.bed) + " m",
            pushed({p.west.bed, 1.3}, {p.east.bed, 1.3}) * push_unit, g * 1.3 * (p.west.bed - p.east.bed) * push_unit,
            1e-9 * push_unit, "Both ends press alike. Its weight, g times the height, pushes the way the bed falls.");
}

TEST_CASE("where the level is the same at both ends nothing is pushed", "[task-3][still]") {
    for (const Ends& p : ends)
        expect_near("a level of 2 m over a bed from " + std::to_string(p.west.bed) + " to " +
                        std::to_string(p.east.bed) + " m",
                    pushed({p.west.bed, 2 - p.west.bed}, {p.east.bed, 2 - p.east.bed}) * push_unit, 0.0 * push_unit,
                    1e-12 * push_unit, "That is a lake: the slope of the bed holds what the pressures differ by.");
}

TEST_CASE("layer by layer it is the same", "[task-3][layers]") {
    for (const Ends& p : ends) {
        // A line from end to end in a thousand strips: each is pushed by the pressures on its sides and by its bed.
        double sum = 0;
        const int strips = 1000;
        auto at = [&](double a, double b, int k) { return a + (b - a) * k / strips; };
        for (int k = 0; k < strips; ++k) {
            const double h1 = at(p.west.height, p.east.height, k), h2 = at(p.west.height, p.east.height, k + 1);
            const double falls = at(p.west.bed, p.east.bed, k) - at(p.west.bed, p.east.bed, k + 1);
            sum += g * (h1 * h1 - h2 * h2) / 2 + g * (h1 + h2) / 2 * falls;
        }
        expect_near("beds of " + std::to_string(p.west.bed) + " and " + std::to_string(p.east.bed) + " m, heights of " +
                        std::to_string(p.west.height) + " and " + std::to_string(p.east.height) + " m",
                    pushed(p.west, p.east) * push_unit, sum * push_unit, 1e-9 * push_unit,
                    "Cut into strips and summed, it must come to what it is in one.");
    }
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    if (task == 1)
        for (const auto& all : {rising, turning})
            for (int n = 0; n < 4; ++n) {
                numbers.push_back(rise(all[n]));
                numbers.push_back(rise(turned(all[n])));
            }
    if (task == 2)
        for (const Neighbours& r : rows)
            for (const auto& end : {west_end(r), east_end(r)}) {
                numbers.push_back(end.bed.value());
                numbers.push_back(end.height.value());
            }
    if (task == 3)
        for (const Ends& p : ends) numbers.push_back(pushed(p.west, p.east));
    return numbers;
}
