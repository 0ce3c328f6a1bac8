// SPDX-License-Identifier: BSL-1.0
// 7.2.6 Second order: the same equations with a line in each column in the place of a step

// A scheme of first order takes a column for level water. So a hump that runs loses height all the way, and only twice
// the columns halve that. A line through each column, as steep as its neighbours allow, and two stages for a step: then
// twice the columns leave a quarter. What the first order keeps is kept: lakes at rest, the volume, no height below
// zero. At a shock nothing is smooth, and both are of first order. (Beyond 7.2.)

#include "claims.hpp"
#include "plot.hpp"

#include <ansatz/water.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <span>
#include <vector>

using namespace ansatz;
using Length = Quantity<unit::Length>;

namespace {
constexpr double g = 9.81;

/// A hump of 10 cm on 1 m of water that all runs to larger x: u = 2 (c - c0), and each c goes on with u + c.
struct Hump {
    static double first_c(double x) { return std::sqrt(g * (1 + 0.1 * std::exp(-(x - 6) * (x - 6)))); }
    static double height(double x, double t) {
        double low = x - 20, high = x;
        for (int n = 0; n < 60; ++n) {
            const double from = 0.5 * (low + high);
            (from + (3 * first_c(from) - 2 * std::sqrt(g)) * t < x ? low : high) = from;
        }
        return first_c(low) * first_c(low) / g;
    }
};
constexpr double until = 1; // s: before it has steepened to a shock

//! [wave]
template <class Policy> Surface<Policy> after_a_second(const Policy& policy, std::size_t count) {
    const ColumnGrid channel(count, 1, 20.0 / double(count) * metre, 1.0 * metre);
    auto state = Surface{policy, channel, 1.0 * metre}.state();
    for (std::size_t i = 0; i < count; ++i) {
        const double c = Hump::first_c(channel.centre_x(i).value());
        state.height[i] = c * c / g;
        state.momentum_x[i] = c * c / g * 2 * (c - std::sqrt(g));
    }
    Surface water{policy, channel, 1.0 * metre, state};
    for (double t = 0; t < until;) {
        const auto dt = std::min(water.longest_step(), (until - t) * second);
        water.step(dt);
        t += dt.value();
    }
    return water;
}
//! [wave]

/// The mean of what its heights are off, of the hump.
template <class Policy> double error(const Surface<Policy>& water) {
    double wrong = 0;
    const std::size_t count = water.grid().columns_x();
    for (std::size_t i = 0; i < count; ++i)
        wrong += std::abs(water.height(i, 0).value() - Hump::height(water.grid().centre_x(i).value(), until));
    return wrong * 20 / double(count) / (0.1 * std::sqrt(std::acos(-1.0)));
}
double percent(double part) { return std::round(1e4 * part) / 100; }

/// How fast water runs that should lie still, over a hump that emerges.
double in_a_lake() {
    const ColumnGrid channel(100, 1, 0.25 * metre, 1.0 * metre);
    std::vector<double> bed;
    for (std::size_t i = 0; i < 100; ++i) {
        const double x = channel.centre_x(i).value() - 10;
        bed.push_back(std::abs(x) < 2 ? 0.2 - 0.05 * x * x : 0.0);
    }
    //! [lake]
    Surface lake{SecondOrderShallowWater{}, channel, std::span<const double>(bed), 0.1 * metre};
    for (int n = 0; n < 200; ++n) lake.step(lake.longest_step());
    //! [lake]
    double most = 0;
    for (std::size_t i = 0; i < 100; ++i) most = std::max(most, std::abs(lake.velocity(i, 0).value()[0]));
    return most;
}
} // namespace

int main() {
    workbook::Claims claim;
    std::vector<double> first, second_;
    for (const std::size_t count : {100U, 200U, 400U, 800U}) {
        first.push_back(error(after_a_second(ShallowWater{}, count)));
        second_.push_back(error(after_a_second(SecondOrderShallowWater{}, count)));
        std::cout << "  " << count << " columns: " << percent(first.back()) << " % of the hump off, to second order "
                  << percent(second_.back()) << " %\n";
    }
    const double order = std::log2(second_[2] / second_[3]);
    std::cout << "Twice the columns leave " << std::round(100 * std::exp2(-order)) / 100 << " of it: order "
              << std::round(100 * order) / 100 << ", and to first order " << std::round(100 * first[3] / first[2]) / 100
              << '\n';
    claim("it is of second order while the water is smooth", order > 1.9 && order < 2.2);
    claim("with 200 columns it is nearer than the first order with 800", second_[1] < first[3]);
    claim("a lake lies still, over ground that emerges too", in_a_lake() < 1e-12);

    workbook::Plot plot("7.2.6", "A hump that has run for a second, in 100 columns of 20 cm");
    plot.x("x").y("height");
    std::vector<Length> places, exact, steps, lines;
    const auto one = after_a_second(ShallowWater{}, 100);
    const auto two = after_a_second(SecondOrderShallowWater{}, 100);
    for (std::size_t i = 25; i < 75; ++i) {
        places.push_back(one.grid().centre_x(i));
        exact.push_back(Hump::height(places.back().value(), until) * metre);
        steps.push_back(one.height(i, 0));
        lines.push_back(two.height(i, 0));
    }
    plot.reference("closed form", places, exact)
        .line("ShallowWater", places, steps)
        .line("SecondOrderShallowWater", places, lines)
        .write();
    return claim.result();
}
