// SPDX-License-Identifier: BSL-1.0
// What accuracy costs in chapter 7: each surface on a seiche and two dam breaks, a map of sines beside
// one that is simulated, and buoyancy by exact shapes and by sampled points

// Read the rows like this: on the seiche, a low wave, the columns of the notes are the cheapest and as exact as Pipes;
// ShallowWater, which is of first order, pays fourteen times as much and damps the wave; to second order it pays four
// times that, and hardly does. On the dams columns and Pipes come to a wall that no finer grid takes away, since their
// water does not carry its momentum along; only shallow water comes nearer, and to second order with a quarter of the
// columns. All pay N^2 for each simulated second: twice as many columns, and twice as many steps.
//
// A map of equal size for each frame: a sum of sines is asked once, costs what it has sines, and its waves run as water
// does, to the last digit, since that is put in. A surface that is simulated is moved in as many steps as Courant's
// limit wants, and its wave of 20 m on 1 m is 1.6 % too fast however fine the map: shallow water knows no dispersion.
// What it has for that is walls, drops and bodies.
//
// A ball whose volume under water is counted from points on a grid is off by about one of their spacings, and N^3
// points are paid for. The closed form is exact.

#include "costs.hpp"

#include <ansatz/water.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <numbers>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

using namespace ansatz;
using workbook::Axis;
using workbook::Costs;
using workbook::Outcome;

namespace {

constexpr double g = 9.81;

/// A channel of 10 m with a closed form for its heights at a time.
struct Problem {
    std::string name;
    double depth, seconds;
    std::function<double(double)> start, exact; ///< m of m
};

/// A low wave that swings to and fro, a millionth of the depth high, so that the linear theory holds.
Problem seiche() {
    const double k = std::numbers::pi / 10, swing = 20 / std::sqrt(g * 1.0);
    auto height = [=](double x) { return 1 + 1e-6 * std::cos(k * x); };
    return {"seiche", 1, 4.5 * swing, height, height};
}
/// A dam at 5 m over `low` metres of water, after 6 s: Ritter and Stoker, as SWASHES has them.
Problem dam(double low) {
    const double high = 0.005, c = std::sqrt(g * high);
    double below = low, above = high;
    for (int n = 0; n < 100 && low > 0; ++n) {
        const double h = 0.5 * (below + above);
        const double left = 2 * (c - std::sqrt(g * h)), right = (h - low) * std::sqrt(g * (h + low) / (2 * h * low));
        (left > right ? below : above) = h;
    }
    const double middle = low > 0 ? 0.5 * (below + above) : 0.0, u = 2 * (c - std::sqrt(g * middle));
    const double shock = low > 0 ? middle * u / (middle - low) : 2 * c;
    return {low > 0 ? "dam over wet ground" : "dam over dry ground", high, 6,
            [=](double x) { return x < 5 ? high : low; },
            [=](double x) {
                const double xi = (x - 5) / 6;
                if (xi <= -c) return high;
                if (xi <= u - std::sqrt(g * middle)) return 4 / (9 * g) * (c - xi / 2) * (c - xi / 2);
                return xi <= shock ? middle : low;
            }};
}

/// Steps that are a fraction of the longest one, and what is measured behind each: `measure(water, s)`.
template <class Policy, class F>
Surface<Policy> run(const Policy& policy, const Problem& problem, std::size_t count, int& steps, F&& measure) {
    Surface<Policy> water(policy, ColumnGrid(count, 1, 10.0 / double(count) * metre, 1.0 * metre), 0.0 * metre);
    for (std::size_t i = 0; i < count; ++i)
        water.set_height(i, 0, problem.start(water.grid().centre_x(i).value()) * metre);
    // The equations of shallow water say half of what the others say of the same waves.
    constexpr bool half = std::is_same_v<Policy, ShallowWater> || std::is_same_v<Policy, SecondOrderShallowWater>;
    const double part = half ? 0.9 : 0.45;
    double time = 0;
    for (steps = 0; time < problem.seconds; ++steps) {
        const double dt = std::min(part * water.longest_step().value(), problem.seconds - time);
        water.step(dt * second);
        time = dt < problem.seconds - time ? time + dt : problem.seconds;
        measure(water, time);
    }
    return water;
}
constexpr auto nothing = [](const auto&, double) {};

/// The mean error of the heights, and whether one of them was negative on the way.
template <class Policy> Outcome heights(const Policy& policy, const Problem& problem, std::size_t count) {
    int steps = 0;
    double lowest = 0, sum = 0;
    const auto water = run(policy, problem, count, steps, [&](const auto& now, double) {
        lowest = std::min(lowest, *std::min_element(now.heights().begin(), now.heights().end()));
    });
    for (std::size_t i = 0; i < count; ++i)
        sum += std::abs(water.height(i, 0).value() - problem.exact(water.grid().centre_x(i).value()));
    return {.error = sum / double(count) / problem.depth,
            .work = double(steps) * double(count),
            .diverged = lowest < -1e-6 * problem.depth};
}
/// The error of the period and the part of the height that is lost in a swing, whichever is larger.
/// \param swing the period that it should have, s
template <class Policy>
Outcome swings(const Policy& policy, const Problem& problem, std::size_t count, double swing = 20 / std::sqrt(g)) {
    int steps = 0;
    double before = 1, time_before = 0;
    std::vector<double> crossings, tops{problem.start(5.0 / double(count)) - 1};
    double top = 0;
    run(policy, problem, count, steps, [&](const auto& now, double time) {
        const double height = now.heights()[0] - 1;
        if (before < 0 && height >= 0)
            crossings.push_back(time_before + (time - time_before) * before / (before - height));
        if (before > 0 && height <= 0 && !crossings.empty()) tops.push_back(top);
        top = height > 0 ? std::max(top, height) : 0;
        before = height;
        time_before = time;
    });
    const double count_of = double(crossings.size() - 1);
    const double period = std::abs((crossings.back() - crossings.front()) / count_of / swing - 1);
    const double loss = 1 - std::pow(tops.back() / tops.front(), 1 / double(tops.size() - 1));
    return {.error = std::max(period, loss), .work = double(steps) * double(count)};
}

template <class Policy>
void add_surface(Costs& costs, const Axis& axis, const char* choice, const Policy& policy, const Problem& problem,
                 workbook::Number order) {
    const bool swinging = problem.name == "seiche";
    for (const std::size_t count : {25U, 50U, 100U, 200U, 400U})
        costs.add(
            axis,
            {.choice = choice,
             .problem = problem.name,
             .parameter = {"dx", 10.0 / double(count) * metre},
             .n = double(count),
             .known_order = order,
             .error_run = [=] { return swinging ? swings(policy, problem, count) : heights(policy, problem, count); },
             .timed_run =
                 [=] {
                     int steps = 0;
                     return run(policy, problem, count, steps, nothing).heights()[count / 2];
                 },
             .per = problem.seconds});
}

/// The swing of a wave of 20 m on water that is 1 m deep, by linear theory: w^2 = g k tanh(k d).
double real_swing() {
    const double k = std::numbers::pi / 10;
    return 2 * std::numbers::pi / std::sqrt(g * k * std::tanh(k));
}
/// A square map of 10 m, moved by a policy for a frame of 1/60 s.
template <class Policy>
void add_frame(Costs& costs, const Axis& axis, const char* choice, const Policy& policy, std::size_t count) {
    auto water = std::make_shared<Surface<Policy, float>>(
        policy, ColumnGrid(count, count, 10.0 / double(count) * metre), 1.0 * metre);
    water->set_height(count / 2, count / 3, Quantity<unit::Length, float>::from_value(1.1F));
    const double substeps = std::ceil(1.0 / 60 / (0.95 * water->longest_step().value()));
    costs.add(axis, {.choice = choice,
                     .problem = "a map for a frame of 1/60 s",
                     .parameter = {"dx", 10.0 / double(count) * metre},
                     .n = double(count) * double(count),
                     .known_order = {},
                     .error_run =
                         [=] {
                             auto all = swings(policy, seiche(), count, real_swing());
                             all.work = substeps * double(count) * double(count);
                             return all;
                         },
                     .timed_run =
                         [=] {
                             for (int part = 0; part < int(substeps); ++part) water->step(1 / (60 * substeps) * second);
                             return water->heights()[count + 1];
                         }});
}
/// The same map as a sum of sines.
void add_functions(Costs& costs, const Axis& axis, int waves, std::size_t count) {
    std::vector<Wave> all{{20.0 * metre, 0.5e-6 * metre}, {20.0 * metre, 0.5e-6 * metre, std::numbers::pi}};
    for (int n = 2; n < waves; ++n) all.push_back({(20.0 / n) * metre, 0.0 * metre, 0.4 * n}); // no part of the swing
    const Waves sum(all, 1.0 * metre);
    auto heights = std::make_shared<std::vector<float>>(count * count);
    const auto dx = 10.0 / double(count) * metre;
    costs.add(axis, {.choice = std::to_string(waves) + " sines",
                     .problem = "a map for a frame of 1/60 s",
                     .parameter = {"dx", dx},
                     .n = double(count) * double(count),
                     .known_order = {},
                     .error_run =
                         [=] {
                             // The fourth time that the wall's height is at its mean: 7/4 of a swing.
                             double low = 1.6 * real_swing(), high = 1.9 * real_swing();
                             for (int n = 0; n < 60; ++n) {
                                 const double middle = 0.5 * (low + high);
                                 (sum.height(0.0 * metre, 0.0 * metre, middle * second).value() < 0 ? low : high) =
                                     middle;
                             }
                             return Outcome{.error = std::abs(low / (1.75 * real_swing()) - 1),
                                            .work = double(waves) * double(count) * double(count)};
                         },
                     .timed_run =
                         [=] {
                             sum.fill(std::span<float>(*heights), count, count, 0.0 * metre, 0.0 * metre, dx, dx,
                                      1.0 * second);
                             return (*heights)[count + 1];
                         }});
}
/// How much of a ball is under water, from the points of a grid that are in both.
double by_points(double radius, double depth, int n) {
    const double width = 2 * radius / n;
    int inside = 0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
            for (int k = 0; k < n; ++k) {
                const double x = (i + 0.5) * width - radius, y = (j + 0.5) * width - radius,
                             z = (k + 0.5) * width - radius;
                inside += x * x + y * y + z * z <= radius * radius && y <= depth - radius;
            }
    return inside * width * width * width;
}
void add_buoyancy(Costs& costs, const Axis& axis) {
    const double radius = 0.5, all = 4.0 / 3 * std::numbers::pi * radius * radius * radius;
    // The largest over depths that no grid has.
    auto error = [=](auto&& volume) {
        double most = 0;
        for (double depth = 0.0137; depth < 1; depth += 0.0311) {
            const double exact = std::numbers::pi * depth * depth * (3 * radius - depth) / 3;
            most = std::max(most, std::abs(volume(depth) - exact) / all);
        }
        return most;
    };
    for (const int n : {4, 8, 16, 32})
        costs.add(axis, {.choice = "points",
                         .problem = "a ball",
                         .parameter = {"spacing", 1.0 / n * metre},
                         .n = double(n) * n * n,
                         .known_order = {},
                         .error_run =
                             [=] {
                                 return Outcome{.error = error([=](double d) { return by_points(radius, d, n); }),
                                                .work = double(n) * n * n};
                             },
                         .timed_run = [=] { return by_points(radius, 0.317, n); }});
    costs.add(axis, {.choice = "Sphere",
                     .problem = "a ball",
                     .parameter = {},
                     .n = 1,
                     .known_order = {},
                     .error_run =
                         [=] {
                             return Outcome{.error = error([=](double d) {
                                                return submerged(Sphere{radius * metre}, d * metre).volume.value();
                                            }),
                                            .work = 1};
                         },
                     .timed_run = [=] { return submerged(Sphere{radius * metre}, 0.317 * metre).volume.value(); }});
}

} // namespace

int main(int argc, char** argv) {
    Costs costs("water", argc, argv);
    const Axis wave{.name = "wave",
                    .error_norm = "error of the period, or loss of height in a swing",
                    .work_unit = "columns moved",
                    .time_unit = "ns per simulated second"};
    const Axis water{.name = "dam",
                     .error_norm = "mean |h - exact| / h_0",
                     .work_unit = "columns moved",
                     .time_unit = "ns per simulated second",
                     .has_order = false};
    const auto low = seiche(), dry = dam(0), wet = dam(0.001);
    const WaterColumns on_one_metre{std::sqrt(g * 1.0) * metre_per_second},
        in_the_dam{std::sqrt(g * 0.005) * metre_per_second};
    add_surface(costs, wave, "WaterColumns", on_one_metre, low, 2.0);
    add_surface(costs, wave, "Pipes", Pipes{}, low, 2.0);
    add_surface(costs, wave, "ShallowWater", ShallowWater{}, low, 1.0);
    add_surface(costs, wave, "SecondOrderShallowWater", SecondOrderShallowWater{}, low, 2.0);
    for (const auto& problem : {wet, dry}) {
        add_surface(costs, water, "WaterColumns", in_the_dam, problem, {});
        add_surface(costs, water, "Pipes", Pipes{}, problem, {});
        add_surface(costs, water, "ShallowWater", ShallowWater{}, problem, {});
        add_surface(costs, water, "SecondOrderShallowWater", SecondOrderShallowWater{}, problem, {});
    }
    const Axis buoyancy{.name = "buoyancy",
                        .error_norm = "max |V - exact| / V_ball",
                        .work_unit = "points",
                        .time_unit = "ns a body",
                        .has_order = false};
    add_buoyancy(costs, buoyancy);
    const Axis map{.name = "map",
                   .error_norm = "error of the period, by w^2 = g k tanh(k d), or loss of height in a swing",
                   .work_unit = "heights",
                   .time_unit = "ns a frame",
                   .has_order = false};
    for (const std::size_t count : {64U, 128U, 256U, 512U}) {
        add_functions(costs, map, 2, count);
        add_functions(costs, map, 16, count);
        add_frame(costs, map, "WaterColumns", on_one_metre, count);
        add_frame(costs, map, "Pipes", Pipes{}, count);
        add_frame(costs, map, "ShallowWater", ShallowWater{}, count);
    }
    return costs.run();
}
