// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on a sum of waves (notes 7.3).

#include "tools/exercises/expect.hpp"

#include <ansatz/world.hpp>

#include <cmath>
#include <limits>

using namespace ansatz;
using namespace ansatz::workbook;

namespace {

const double pi = std::acos(-1.0), bottomless = std::numeric_limits<double>::infinity();

struct Water {
    double wavelength, depth, g;
    double k() const { return 2 * pi / wavelength; }
    auto omega() const {
        return exercise::angular_frequency(wavelength * metre, depth * metre, g * metre_per_second_squared);
    }
    auto group_speed() const {
        return exercise::group_speed(wavelength * metre, depth * metre, g * metre_per_second_squared);
    }
    /// By the relation itself, for the tests of what is built on it.
    double right_omega(double at_k) const { return std::sqrt(g * at_k * std::tanh(at_k * depth)); }
};
const Water deep[] = {{12, bottomless, 9.81}, {0.7, bottomless, 1.6}, {90, 500, 9.81}};
const Water shallow[] = {{700, 0.5, 9.81}, {90, 0.06, 3.7}};
const Water moderate[] = {{12, 2, 9.81}, {3, 0.4, 1.6}, {40, 9, 9.81}};
std::string said(const Water& w) {
    std::ostringstream text;
    text << "waves of " << w.wavelength << " m in water of " << w.depth << " m, g = " << w.g << " m/s^2";
    return text.str();
}

const std::vector<exercise::Wave> waves = {
    {5.0 * metre, 0.3 * metre}, {1.7 * metre, 0.12 * metre}, {9.0 * metre, 0.5 * metre}};
const auto depth = 1.3 * metre;
const auto gravity = 9.81 * metre_per_second_squared;
auto height(const std::vector<exercise::Wave>& some, double x, double t) {
    return exercise::height(some, depth, gravity, x * metre, t * second);
}
std::string said(const exercise::Wave& w) {
    std::ostringstream text;
    text << "a wave of " << w.wavelength << " and an amplitude of " << w.amplitude << " in water of 1.3 m";
    return text.str();
}
double right_omega(const exercise::Wave& w) {
    return Water{w.wavelength.value(), depth.value(), 9.81}.right_omega(2 * pi / w.wavelength.value());
}

} // namespace

TEST_CASE("in deep water omega^2 is g k", "[task-1][deep]") {
    for (const Water& w : deep)
        expect_near(said(w) + ": omega", w.omega(), std::sqrt(w.g * w.k()) * hertz, 1e-9 * hertz,
                    "A wave does not feel a ground that is deeper than it is long, and k is 2 pi over its length.");
}

TEST_CASE("in shallow water all waves run at sqrt(g d)", "[task-1][shallow]") {
    for (const Water& w : shallow)
        expect_near(said(w) + ": omega / k", w.omega() / (w.k() / metre), std::sqrt(w.g * w.depth) * metre_per_second,
                    1e-4 * std::sqrt(w.g * w.depth) * metre_per_second,
                    "tanh(k d) is k d where that is small, so that the length of the wave cancels.");
}

TEST_CASE("in between tanh(k d) decides", "[task-1][between]") {
    for (const Water& w : moderate) {
        const double down = std::exp(-2 * w.k() * w.depth); // tanh from one exponential
        expect_near(said(w) + ": omega^2", w.omega() * w.omega(), w.g * w.k() * (1 - down) / (1 + down) * hertz * hertz,
                    1e-9 * hertz * hertz, "All of the right side is under the root, and k is in the tanh, too.");
    }
}

TEST_CASE("at x = 0 and t = 0 all crests meet", "[task-2][crests]") {
    expect_near("three waves of 0.3, 0.12 and 0.5 m: their height where all begin", height(waves, 0, 0), 0.92 * metre,
                1e-12 * metre, "An amplitude is the height of a crest over still water, and heights add.");
}

TEST_CASE("a wave repeats after its length, and not before", "[task-2][length]") {
    for (const auto& w : waves)
        for (const double x : {0.4, -1.1}) {
            const double length = w.wavelength.value();
            expect_agree(said(w) + ", at x and one length on", "yours, at x", height({w}, x, 0.3),
                         "yours, one length on", height({w}, x + length, 0.3), 1e-9 * metre,
                         "The argument of the cosine grows by 2 pi in a wavelength.");
            expect_agree(said(w) + ", at x and half of a length on", "yours, at x", height({w}, x, 0.3),
                         "the opposite of yours, half a length on", -height({w}, x + length / 2, 0.3), 1e-9 * metre,
                         "Half a length from a crest there is a trough.");
        }
}

TEST_CASE("a crest runs to where x is larger, as fast as the water says", "[task-2][runs]") {
    for (const auto& w : waves) {
        const double c = right_omega(w) * w.wavelength.value() / (2 * pi);
        for (const double t : {0.5, 2.2})
            expect_near(said(w) + ": its height where the crest is that began at x = 0", height({w}, c * t, t),
                        w.amplitude, 1e-9 * metre,
                        "Go along with the crest, and it stays a crest: k x - omega t is zero there.");
    }
}

TEST_CASE("each wave has its own speed", "[task-2][sum]") {
    for (const double x : {0.7, 3.1})
        for (const double t : {0.4, 5.0}) {
            auto sum = 0.0 * metre;
            for (const auto& w : waves)
                sum += w.amplitude * std::cos(2 * pi * x / w.wavelength.value() - right_omega(w) * t);
            expect_near(
                "three waves, at x = " + std::to_string(x) + " m, t = " + std::to_string(t) + " s: their height",
                height(waves, x, t), sum, 1e-9 * metre, "The sum of the three, each with the omega of its own length.");
        }
}

TEST_CASE("in deep water a group runs half as fast as its crests", "[task-3][half]") {
    for (const Water& w : deep)
        expect_near(said(w) + ": the speed of a group", w.group_speed(),
                    0.5 * std::sqrt(w.g / w.k()) * metre_per_second, 1e-6 * metre_per_second,
                    "omega is the root of g k, and the slope of a root is half of what it is over k.");
}

TEST_CASE("in shallow water it runs along with them", "[task-3][along]") {
    for (const Water& w : shallow)
        expect_near(said(w) + ": the speed of a group", w.group_speed(), std::sqrt(w.g * w.depth) * metre_per_second,
                    1e-4 * std::sqrt(w.g * w.depth) * metre_per_second,
                    "omega is in proportion to k there: the slope is the same everywhere.");
}

TEST_CASE("it is the slope of omega over k", "[task-3][slope]") {
    for (const Water& w : moderate) {
        const double by = 1e-4 * w.k();
        const double right = (w.right_omega(w.k() + by) - w.right_omega(w.k() - by)) / (2 * by);
        expect_near(said(w) + ": the speed of a group", w.group_speed(), right * metre_per_second,
                    1e-6 * metre_per_second,
                    "Two waves that differ a little in k beat, and the beat runs by the difference in omega over the "
                    "difference in k.");
    }
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    if (task == 2)
        for (const double x : {0.3, 2.6})
            for (const double t : {0.7, 1.9}) {
                numbers.push_back(height(waves, x, t).value());
                numbers.push_back(height({waves[1]}, x, t).value());
            }
    else
        for (const auto& some : {std::vector<Water>(std::begin(deep), std::end(deep)),
                                 std::vector<Water>(std::begin(shallow), std::end(shallow)),
                                 std::vector<Water>(std::begin(moderate), std::end(moderate))})
            for (const Water& w : some) numbers.push_back(task == 1 ? w.omega().value() : w.group_speed().value());
    return numbers;
}
