// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on one contact for many columns (notes 7.4).

#include "tools/exercises/expect.hpp"

#include <ansatz/world.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

using namespace ansatz;
using namespace ansatz::workbook;

namespace {

using exercise::Body;
using exercise::Contact;
using exercise::Surface;

const auto reach = 0.6 * metre;
const double places[] = {1.47, 1.62, 2.2, 3.07};

/// Thirteen columns of 0.3 m that rise and fall.
Surface waves() {
    Surface all{0.3 * metre, {}, {}};
    for (int i = 0; i < 13; ++i) {
        all.heights.push_back((0.2 * std::sin(1.1 * i) + 0.01 * i) * metre);
        all.rises.push_back((0.5 * std::cos(0.7 * i) + 0.2) * metre_per_second);
    }
    return all;
}
Surface level(double height) {
    return {0.3 * metre, std::vector<Quantity<unit::Length>>(13, height * metre),
            std::vector<Quantity<unit::Velocity>>(13, 0.0 * metre_per_second)};
}
/// Of the columns' heights by the weights that were given.
double mean_height(const Surface& surface, double at) {
    const auto weights = exercise::weights(surface, at * metre, reach);
    double sum = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) sum += weights[i] * surface.heights[i].value();
    return sum;
}
Body body(double at, double height, double vx, double vy) {
    return {metres(at, height), metres_per_second(vx, vy), reach};
}
const Contact spring{800.0 * newton_per_metre, 0.0 * newton_second_per_metre},
    damped{800.0 * newton_per_metre, 60.0 * newton_second_per_metre};
std::string over(double at) { return "over " + std::to_string(at).substr(0, 4) + " m"; }
double sum_of(const std::vector<double>& all) { return std::accumulate(all.begin(), all.end(), 0.0); }
/// What a body's deepest point has of the surface over it, m; by the weights of the notes' page and not by the
/// answer's.
double depth_of(const Surface& surface, const Body& body) {
    double sum = 0, high = 0;
    for (std::size_t i = 0; i < surface.heights.size(); ++i) {
        const double r = double(i) * surface.width.value() - body.position.value()[0], R = body.radius.value();
        const double w = std::abs(r) < R ? std::pow(1 - r * r / (R * R), 2) : 0;
        sum += w;
        high += w * surface.heights[i].value();
    }
    return high / sum - body.position.value()[1] + body.radius.value();
}
/// All that moves, a time later.
void advance(Surface& surface, Body& body, double time) {
    for (std::size_t i = 0; i < surface.heights.size(); ++i) surface.heights[i] += time * second * surface.rises[i];
    body.position += time * second * body.velocity;
}
double power(const exercise::Forces& forces, const Surface& surface, const Body& body) {
    double sum = forces.on_body.value().dot(body.velocity.value());
    for (std::size_t i = 0; i < forces.on_columns.size(); ++i)
        sum += forces.on_columns[i].value() * surface.rises[i].value();
    return sum;
}
void expect_nothing(const std::string& who, const exercise::Forces& forces, const std::string& why) {
    expect_near("the force on a body " + who, forces.on_body, newtons(0, 0), 1e-12 * newton, why);
    for (const auto& force : forces.on_columns)
        expect_near("the force on a column, with a body " + who, force, 0.0 * newton, 1e-12 * newton, why);
}

} // namespace

TEST_CASE("they are one in all", "[task-1][sum]") {
    for (const double at : {0.0, 0.1, 1.5, 1.62, 2.2, 3.6}) {
        const auto weights = exercise::weights(waves(), at * metre, reach);
        expect(weights.size() == 13, "weights has " + std::to_string(weights.size()) + " numbers for 13 columns.");
        expect_near("the sum of the weights " + over(at), sum_of(weights), 1.0, 1e-12,
                    "Each is divided by the sum of all, at the ends of the surface, too.");
    }
}

TEST_CASE("by the square of what is left", "[task-1][shape]") {
    const auto weights = exercise::weights(waves(), 1.5 * metre, reach); // over column 5
    for (const auto& [column, right] :
         {std::pair(5, 1.0), std::pair(6, 0.5625), std::pair(4, 0.5625), std::pair(7, 0.0)})
        expect_near("the weight of column " + std::to_string(column) +
                        " for a body over column 5, as a fraction of that one's",
                    weights[std::size_t(column)] / weights[5], right, 1e-12,
                    "The columns are 0.3 m apart, and the footprint reaches for 0.6 m: (1 - (0.3 / 0.6)^2)^2.");
    const auto beside = exercise::weights(waves(), 1.6 * metre, reach);
    expect_near("the weight of column 6 for a body 0.2 m beside it, as a fraction of that of column 5, 0.1 m beside",
                beside[6] / beside[5], std::pow(1 - 1 / 9.0, 2) / std::pow(1 - 1 / 36.0, 2), 1e-12,
                "(1 - (0.2 / 0.6)^2)^2 and (1 - (0.1 / 0.6)^2)^2.");
}

TEST_CASE("nothing at the rim and beyond", "[task-1][rim]") {
    for (const double at : {1.5, 1.62, 2.2, 3.07}) {
        const auto weights = exercise::weights(waves(), at * metre, reach);
        for (std::size_t i = 0; i < weights.size(); ++i)
            if (std::abs(0.3 * double(i) - at) >= 0.6)
                expect_near("the weight of column " + std::to_string(i) + " for a body " + over(at), weights[i], 0.0,
                            1e-12,
                            "It is " + std::to_string(std::abs(0.3 * double(i) - at)) +
                                " m away, and the footprint reaches for 0.6 m.");
    }
}

TEST_CASE("no column comes with a jerk", "[task-1][smooth]") {
    for (double at = 1; at < 2.5; at += 0.01) {
        const auto one = exercise::weights(waves(), at * metre, reach),
                   next = exercise::weights(waves(), (at + 1e-5) * metre, reach);
        for (std::size_t i = 0; i < one.size(); ++i)
            expect_agree("the weight of column " + std::to_string(i), over(at), one[i],
                         "a hundredth of a millimetre further", next[i], 1e-4,
                         "Where a body slides from column to column, each counts for more or less by and by.");
    }
}

TEST_CASE("out of reach they are all zero", "[task-1][nobody]") {
    for (const double at : {-4.0, 30.0})
        for (const double weight : exercise::weights(waves(), at * metre, reach))
            expect_near("the weight of a column for a body " + over(at) + ", away from the surface", weight, 0.0, 0.0,
                        "No column is near, and nothing may be divided by the sum, which is zero.");
}

TEST_CASE("the rate of the mean", "[task-2][difference]") {
    const auto surface = waves();
    for (const double at : places) {
        const double yours = exercise::slope(surface, at * metre, reach);
        const double h = 1e-4, right = (mean_height(surface, at + h) - mean_height(surface, at - h)) / (2 * h);
        expect_near("the slope of the mean " + over(at), yours, right, 1e-6,
                    "What the mean by your weights changes from 0.1 mm before to 0.1 mm behind, by 0.2 mm.");
    }
}

TEST_CASE("near the end of the surface, too", "[task-2][end]") {
    const auto surface = waves();
    for (const double at : {0.05, 0.2, 3.45}) {
        const double yours = exercise::slope(surface, at * metre, reach);
        const double h = 1e-4, right = (mean_height(surface, at + h) - mean_height(surface, at - h)) / (2 * h);
        expect_near("the slope of the mean " + over(at), yours, right, 1e-6,
                    "Half of the footprint has no columns there: the sum of the weights changes with x as well.");
    }
}

TEST_CASE("what is level has none", "[task-2][level]") {
    for (const double height : {0.0, 3.0})
        for (const double at : {0.1, 1.62, 2.2})
            expect_near("the slope of a surface that is level at " + std::to_string(height) + " m, " + over(at),
                        exercise::slope(level(height), at * metre, reach), 0.0, 1e-12,
                        "However the weights change, the mean of equal heights does not.");
    expect_near("the slope where no column is in reach", exercise::slope(waves(), -4.0 * metre, reach), 0.0, 0.0,
                "Nothing may be divided by the sum of the weights, which is zero.");
}

TEST_CASE("a body at rest is pushed by k d", "[task-3][depth]") {
    auto surface = level(0.4);
    for (const double depth : {0.05, 0.3}) {
        const auto forces = exercise::carry(surface, body(1.62, 0.4 + 0.6 - depth, 0, 0), spring);
        expect_near("the force on a body at rest, whose lowest point is " + std::to_string(depth).substr(0, 4) +
                        " m under a level surface",
                    forces.on_body, newtons(0, 800 * depth), 1e-9 * newton,
                    "k is 800 N/m. Its lowest point is a radius, 0.6 m, under its position.");
    }
}

TEST_CASE("above the surface there is nothing", "[task-3][slack]") {
    for (const double at : places)
        for (const double vy : {-5.0, 5.0}) {
            auto high = body(at, 0, 1, vy);
            high.position += metres(0, depth_of(waves(), high) + 0.01);
            expect_nothing("1 cm above the surface, " + over(at), exercise::carry(waves(), high, damped),
                           "The spring is slack there, and its damping is, too.");
        }
    expect_nothing("that is deep, but away from the surface", exercise::carry(waves(), body(-4, -3, 0, 0), spring),
                   "No column is within reach.");
}

TEST_CASE("it never pulls", "[task-3][pull]") {
    auto leaves = body(1.62, 0, 0, 9);
    leaves.position += metres(0, depth_of(waves(), leaves) - 0.02);
    expect_nothing("2 cm deep that leaves with 9 m/s", exercise::carry(waves(), leaves, damped),
                   "k d is 16 N, and c times how fast it gets less deep is far more: the sum is negative.");
}

TEST_CASE("the columns get the rest", "[task-3][columns]") {
    for (const double at : places) {
        auto lies = body(at, 0, 0.4, -0.7);
        lies.position += metres(0, depth_of(waves(), lies) - 0.25);
        const auto forces = exercise::carry(waves(), lies, damped);
        const auto weights = exercise::weights(waves(), at * metre, reach);
        for (std::size_t i = 0; i < weights.size(); ++i)
            expect_near("the force on column " + std::to_string(i) + " under a body " + over(at), forces.on_columns[i],
                        -weights[i] * forces.on_body.value()[1] * newton, 1e-9 * newton,
                        "What the body is pushed up with the columns are pushed down with, each by its weight.");
    }
}

TEST_CASE("nobody gets energy from nothing", "[task-3][energy]") {
    for (const double at : places)
        for (const double vx : {-3.0, 0.0, 2.0}) {
            auto lies = body(at, 0, vx, -0.7);
            lies.position += metres(0, depth_of(waves(), lies) - 0.25);
            const auto surface = waves();
            auto energy = [&](double time) {
                auto water = surface;
                auto moved = lies;
                advance(water, moved, time);
                const double d = depth_of(water, moved);
                return 800 * d * d / 2;
            };
            const double h = 1e-5, right = -(energy(h) - energy(-h)) / (2 * h);
            expect_near("the power of all forces, for a body " + over(at) + " that goes with " +
                            std::to_string(vx).substr(0, 4) + " m/s along the surface",
                        power(exercise::carry(surface, lies, spring), surface, lies) * watt, right * watt, 1e-4 * watt,
                        "What the spring's energy, k d^2 / 2, loses the body and the columns get, and no more.");
        }
}

TEST_CASE("damping takes c times the square of the rate", "[task-3][damping]") {
    for (const double at : places)
        for (const double vx : {-1.0, 0.0, 1.0}) {
            auto lies = body(at, 0, vx, -0.7);
            const auto surface = waves();
            lies.position += metres(0, depth_of(surface, lies) - 0.25);
            auto depth = [&](double time) {
                auto water = surface;
                auto moved = lies;
                advance(water, moved, time);
                return depth_of(water, moved);
            };
            const double h = 1e-5, rate = (depth(h) - depth(-h)) / (2 * h);
            expect_near("what damping takes from a body " + over(at) + " that goes with " +
                            std::to_string(vx).substr(0, 4) + " m/s along the surface and gets deeper by " +
                            std::to_string(rate) + " m/s",
                        (power(exercise::carry(surface, lies, spring), surface, lies) -
                         power(exercise::carry(surface, lies, damped), surface, lies)) *
                            watt,
                        60 * rate * rate * watt, 1e-3 * watt, "c is 60 N s/m; the rate is that of the depth.");
        }
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    const double everywhere[] = {-4, 0.05, 1.5, 1.62, 2.2, 3.45};
    if (task == 1)
        for (const double at : everywhere)
            for (const double weight : exercise::weights(waves(), at * metre, reach)) numbers.push_back(weight);
    if (task == 2)
        for (const double at : everywhere) numbers.push_back(exercise::slope(waves(), at * metre, reach));
    if (task == 3)
        for (const double at : everywhere)
            for (const auto& [deep, vx, vy] :
                 {std::tuple(0.25, 0.0, 0.0), std::tuple(0.25, 1.3, -0.7), std::tuple(0.02, 0.0, 9.0),
                  std::tuple(1.5, 0.0, 0.0), std::tuple(-0.1, 0.4, -3.0)}) {
                auto lies = body(at, 0, vx, vy);
                lies.position += metres(0, (at < 0 ? 0 : depth_of(waves(), lies)) - deep);
                const auto forces = exercise::carry(waves(), lies, damped);
                numbers.insert(numbers.end(), {forces.on_body.value()[0], forces.on_body.value()[1]});
                for (const auto& force : forces.on_columns) numbers.push_back(force.value());
            }
    return numbers;
}
