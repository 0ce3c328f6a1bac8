// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on walls (notes 7.2).

#include "tools/exercises/expect.hpp"

#include <ansatz/world.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

using namespace ansatz;
using namespace ansatz::workbook;

namespace {

struct Last {
    double rate, height, inside, level, c, width, dt;
};
const Last lasts[] = {{0.3, 1.2, 1.5, 0.9, 2.0, 0.5, 0.04},
                      {-0.7, 0.8, 0.6, 1.1, 1.3, 0.3, 0.15},
                      {0.05, 1.7, 1.65, 1.75, 3.1, 1.4, 0.2}};
std::string said(const Last& l) {
    std::ostringstream text;
    text << "a last column of " << l.height << " m that rises at " << l.rate << " m/s, beside one of " << l.inside
         << " m, " << l.width << " m wide, waves at " << l.c << " m/s, a step of " << l.dt << " s: its rate afterwards";
    return text.str();
}
auto solid(const Last& l) {
    return exercise::solid(l.rate * metre_per_second, l.height * metre, l.inside * metre, l.c * metre_per_second,
                           l.width * metre, l.dt * second);
}
auto held(const Last& l) {
    return exercise::held(l.rate * metre_per_second, l.height * metre, l.inside * metre, l.level * metre,
                          l.c * metre_per_second, l.width * metre, l.dt * second);
}
auto open(const Last& l) {
    return exercise::open(l.rate * metre_per_second, l.height * metre, l.inside * metre, l.c * metre_per_second,
                          l.width * metre, l.dt * second);
}
const auto exact = 1e-12 * metre_per_second;

/// From the flows of volume through the two faces of the column, by the slopes there.
double by_slopes(const Last& l, double slope_at_wall) {
    const double slope_inside = (l.height - l.inside) / l.width;
    return l.rate + l.c * l.c * (slope_at_wall - slope_inside) / l.width * l.dt;
}

using Ends = std::pair<exercise::End, exercise::End>;
/// A hump of 10 cm over 1 m in the middle of 20 m, or all of it in a half of it.
exercise::Channel channel(Ends ends, double middle = 10, double wide = 1) {
    exercise::Channel all{{}, {}, 0.1 * metre, 1.4 * metre_per_second, 1.0 * metre, ends.first, ends.second};
    for (int n = 0; n < 200; ++n) {
        const double x = 0.1 * (n + 0.5) - middle;
        all.heights.push_back((1 + 0.1 * std::exp(-x * x / (wide * wide))) * metre);
        all.rates.push_back(0.0 * metre_per_second);
    }
    return all;
}
double volume(const exercise::Channel& all) {
    double sum = 0;
    for (const auto& h : all.heights) sum += h.value() * all.width.value();
    return sum;
}
void run(exercise::Channel& all, double seconds, double dt = 0.05) {
    for (int n = 0; n < int(std::lround(seconds / dt)); ++n) exercise::step(all, dt * second);
}
double height(const exercise::Channel& all, double x) {
    return all.heights[std::size_t(x / all.width.value())].value() - 1;
}

} // namespace

TEST_CASE("a solid wall does not pull", "[task-1][level]") {
    for (const Last& l : lasts)
        expect_near(said(l), solid(l), by_slopes(l, 0) * metre_per_second, exact,
                    "The slope to the neighbour pulls, and at the wall the surface is level.");
}

TEST_CASE("as high as its neighbour, nothing pulls", "[task-1][still]") {
    for (Last l : lasts) {
        l.inside = l.height;
        expect_near(said(l), solid(l), l.rate * metre_per_second, exact, "It rises as it rose before.");
    }
}

TEST_CASE("a held level pulls by the slope to it", "[task-2][slope]") {
    for (const Last& l : lasts)
        expect_near(said(l), held(l), by_slopes(l, (l.level - l.height) / (l.width / 2)) * metre_per_second, exact,
                    "The wall is half a width away, so that the slope is twice the difference over the width.");
}

TEST_CASE("at the level that is held it is as beside a solid wall", "[task-2][at-level]") {
    for (Last l : lasts) {
        l.level = l.height;
        expect_near(said(l), held(l), by_slopes(l, 0) * metre_per_second, exact, "There is no slope to the wall then.");
    }
}

TEST_CASE("at an open wall the surface falls outwards by the mean rate over c", "[task-3][outwards]") {
    for (const Last& l : lasts) {
        // The rate for which both sides of the equation are alike, by halving.
        double low = -100, high = 100;
        for (int n = 0; n < 200; ++n) {
            const double after = (low + high) / 2;
            (by_slopes(l, -(l.rate + after) / 2 / l.c) > after ? low : high) = after;
        }
        expect_near(said(l), open(l), low * metre_per_second, 1e-9 * metre_per_second,
                    "The rate afterwards is on both sides of the equation: solve for it.");
    }
}

TEST_CASE("a step, however long, leaves less than there was", "[task-3][less]") {
    for (Last l : lasts) {
        l.inside = l.height;
        for (const double longer : {1.0, 10.0, 1000.0}) {
            l.dt = longer * l.width / l.c;
            const auto after = open(l);
            std::ostringstream text;
            text << said(l) << "\n    yours  " << after
                 << "\nNothing pulls but the wall, which takes: it may not be more than before, up or down.";
            expect(abs(after) < std::abs(l.rate) * metre_per_second, text.str());
        }
    }
}

TEST_CASE("between solid walls no water is lost", "[task-4][kept]") {
    auto all = channel({exercise::End::solid, exercise::End::solid}, 6);
    const double before = volume(all);
    run(all, 30);
    expect_near("the volume after 30 s, for each metre across", volume(all) * square_metre, before * square_metre,
                1e-9 * square_metre, "What one column gains, its neighbour loses.");
}

TEST_CASE("each wall sends back what it should", "[task-4][sent-back]") {
    // The hump divides; each half is at its wall after 10 m, and after 13 m 3 m from it again.
    using exercise::End;
    for (const auto& [kind, right, name] : {std::tuple{End::solid, 0.05, "solid"}, std::tuple{End::held, -0.05, "held"},
                                            std::tuple{End::open, 0.0, "open"}})
        for (const bool west : {true, false}) {
            auto all = channel(west ? Ends{kind, End::solid} : Ends{End::solid, kind});
            run(all, 13 / 1.4);
            std::ostringstream text;
            text << "3 m from the " << (west ? "western" : "eastern") << " wall, " << name
                 << ", when half a hump of 10 cm is back: its height over still water";
            expect_near(text.str(), height(all, west ? 3 : 17) * metre, right * metre, 1.5e-3 * metre,
                        "A solid wall sends it back upright, one that holds upside down, and an open one not at all.");
        }
}

TEST_CASE("all rates come first, by the heights before", "[task-4][first]") {
    using exercise::End;
    for (const auto& ends : {Ends{End::solid, End::held}, Ends{End::open, End::solid}, Ends{End::held, End::open}}) {
        auto all = channel(ends, 7.3, 4);
        for (std::size_t n = 0; n < all.rates.size(); ++n)
            all.rates[n] = 0.01 * std::cos(0.3 * double(n)) * metre_per_second;
        auto mirrored = all;
        std::reverse(mirrored.heights.begin(), mirrored.heights.end());
        std::reverse(mirrored.rates.begin(), mirrored.rates.end());
        std::swap(mirrored.west, mirrored.east);
        const auto before = all;
        exercise::step(all, 0.05 * second);
        exercise::step(mirrored, 0.05 * second);
        for (const std::size_t n : {0UL, 1UL, 50UL, 198UL, 199UL}) {
            std::ostringstream text;
            text << "the height of column " << n << " after a step";
            expect_near(text.str(), all.heights[n], before.heights[n] + all.rates[n] * (0.05 * second), 1e-12 * metre,
                        "Heights move by the rates after the step.");
            expect_agree(text.str(), "in the channel", all.heights[n], "in its mirror", mirrored.heights[199 - n],
                         1e-12 * metre, "East and west are alike: no column moves before all rates are known.");
        }
    }
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    if (task < 4)
        for (const Last& l : lasts) numbers.push_back((task == 1 ? solid(l) : task == 2 ? held(l) : open(l)).value());
    else {
        using exercise::End;
        for (const auto& ends :
             {Ends{End::solid, End::held}, Ends{End::open, End::solid}, Ends{End::held, End::open}}) {
            auto all = channel(ends, 7.3, 4);
            for (std::size_t n = 0; n < 200; ++n) all.rates[n] = 0.3 * std::cos(0.3 * double(n)) * metre_per_second;
            run(all, 0.3, 0.06);
            for (std::size_t n = 0; n < 200; n += n < 4 || n >= 194 ? 1 : 38) {
                numbers.push_back(all.heights[n].value());
                numbers.push_back(all.rates[n].value());
            }
        }
    }
    return numbers;
}
