// SPDX-License-Identifier: BSL-1.0
// Steady flows with a closed form (SWASHES 3.1.3 to 3.1.5 and 3.2.1): over a hump without friction, calm, through the
// critical height, and back over a jump; and MacDonald's channel, whose bed makes up for friction.
//
// All sides of a Surface are walls. So the flow through a channel is held at its ends from outside, as the columns of a
// state can be: this is also how who needs an inflow of his own gets one.
// Compiled alone: its g and its Lake are those of shallow water, and other files that run long have theirs.
// Runs long with the sanitizers.

#include "tests/water/shallow_cases.hpp"

#include <ansatz/water/second_order_shallow_water.hpp>
#include <ansatz/water/shallow_water.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

using namespace water_tests;

namespace {

/// A flow that does not change: bed and height against place, and what passes every place.
struct Flow {
    double length, through; // m, m^2/s
    std::function<double(double)> bed, height;
    double manning = 0; ///< s/m^(1/3), of the channel's friction
};
using State = ShallowWater::State<double>;

/// The channel when it has settled, of so many columns.
template <class Policy> State settled(const Flow& flow, std::size_t count, double until) {
    const auto grid = channel(count, flow.length);
    typename Policy::template In<double> loops(Policy{}, grid, 0.0 * metre);
    State state;
    state.height.resize(count);
    loops.prepare(state, 0.0 * metre);
    std::vector<double> exact;
    for (std::size_t i = 0; i < count; ++i) {
        const double x = grid.centre_x(i).value();
        exact.push_back(flow.height(x));
        state.bed[i] = flow.bed(x);
    }
    // It begins without a flow, with the level of its end, or half as deep as there where the bed is higher.
    const double level = exact.back() + state.bed.back();
    for (std::size_t i = 0; i < count; ++i) state.height[i] = std::max(level - state.bed[i], exact.back() / 2);
    bool dry = false;
    for (double t = 0; t < until;) {
        for (const std::size_t end : {std::size_t(0), std::size_t(1), count - 2, count - 1}) {
            state.height[end] = exact[end];
            state.momentum_x[end] = flow.through;
        }
        const double dt = loops.longest_step(state).value();
        loops.advance(state, dt * second);
        t += dt;
        for (std::size_t i = 0; i < count; ++i) {
            dry = dry || !(state.height[i] > 0);
            state.momentum_x[i] /= 1 + dt * g * flow.manning * flow.manning * std::abs(state.momentum_x[i]) /
                                           std::pow(state.height[i], 7.0 / 3);
        }
    }
    REQUIRE_FALSE(dry);
    return state;
}
/// The mean of what heights are off, over what they should be.
/// \param but_for m, of a jump: a metre around it is left out
double off_from(const Flow& flow, const State& state, double but_for) {
    double sum = 0;
    int looked_at = 0;
    const auto grid = channel(state.height.size(), flow.length);
    for (std::size_t i = 2; i + 2 < state.height.size(); ++i) {
        const double x = grid.centre_x(i).value(), exact = flow.height(x);
        if (std::abs(x - but_for) < 1) continue;
        sum += std::abs(state.height[i] / exact - 1);
        ++looked_at;
    }
    return sum / looked_at;
}

double hump_at(double x) { return std::abs(x - 10) < 2 ? 0.2 - 0.05 * (x - 10) * (x - 10) : 0.0; }
double critical(double q, double gravity = g) { return std::cbrt(q * q / gravity); }
/// Bernoulli: what stands above a bed z where h + z + q^2 / 2 g h^2 is `head`, slower than its waves or faster.
double height_of(double head, double z, double q, bool slow, double gravity = g) {
    const double at = critical(q, gravity);
    double low = slow ? at : 1e-6, high = slow ? head - z : at;
    for (int n = 0; n < 200; ++n) {
        const double h = 0.5 * (low + high);
        const bool more = h + z + q * q / (2 * gravity * h * h) > head;
        (more == slow ? high : low) = h;
    }
    return 0.5 * (low + high);
}
double head_of(double h, double z, double q, double gravity = g) { return h + z + q * q / (2 * gravity * h * h); }

/// Calm all along: 2 m deep at the end.
Flow calm() {
    const double q = 4.42, head = head_of(2, 0, q);
    return {25, q, hump_at, [=](double x) { return height_of(head, hump_at(x), q, true); }};
}
/// Critical on the hump, and fast behind it.
Flow rapid() {
    const double q = 1.53, head = head_of(critical(q), 0.2, q);
    return {25, q, hump_at, [=](double x) { return height_of(head, hump_at(x), q, x < 10); }};
}
/// The same with 0.33 m at the end: a jump, over which momentum is kept and energy is not.
double jump(double gravity = g) {
    const double q = 0.18, before = head_of(critical(q, gravity), 0.2, q, gravity),
                 after = head_of(0.33, 0, q, gravity);
    const auto push = [&](double head, double z, bool slow) {
        const double h = height_of(head, z, q, slow, gravity);
        return q * q / h + gravity * h * h / 2;
    };
    double low = 10, high = 12;
    for (int n = 0; n < 100; ++n) {
        const double x = 0.5 * (low + high), z = hump_at(x);
        (push(before, z, false) > push(after, z, true) ? low : high) = x;
    }
    return 0.5 * (low + high);
}
Flow with_a_jump() {
    const double q = 0.18, before = head_of(critical(q), 0.2, q), after = head_of(0.33, 0, q), at = jump();
    return {25, q, hump_at, [=](double x) {
                return x < at ? height_of(before, hump_at(x), q, x < 10) : height_of(after, hump_at(x), q, true);
            }};
}
/// MacDonald's: the height is given, and the bed is what makes it so: b' = (q^2 / g h^3 - 1) h' - n^2 q^2 / h^(10/3).
Flow macdonald() {
    const double q = 2, n = 0.033, length = 1000;
    const auto height = [](double x) {
        const double part = x / 1000 - 0.5;
        return std::cbrt(4 / g) * (1 + 0.5 * std::exp(-16 * part * part));
    };
    const auto fall = [=](double x) {
        const double h = height(x), part = x / 1000 - 0.5,
                     rise = std::cbrt(4 / g) * 0.5 * std::exp(-16 * part * part) * -32 * part / 1000;
        return (q * q / (g * h * h * h) - 1) * rise - n * n * q * q / std::pow(h, 10.0 / 3);
    };
    // Simpson's rule from the end, 0.05 m a piece.
    const auto bed = [=](double x) {
        const int pieces = std::max(1, int((length - x) / 0.05));
        const double w = (length - x) / pieces;
        double sum = 0;
        for (int k = 0; k < pieces; ++k)
            sum += w / 6 * (fall(x + k * w) + 4 * fall(x + (k + 0.5) * w) + fall(x + (k + 1) * w));
        return -sum;
    };
    return {length, q, bed, height, n};
}
template <class Policy>
std::vector<double> errors(const Flow& flow, std::size_t first, double until, double but_for = -1) {
    std::vector<double> all;
    for (const std::size_t count : {first, 2 * first, 4 * first})
        all.push_back(off_from(flow, settled<Policy>(flow, count, until), but_for));
    return all;
}

} // namespace

TEST_CASE("calm water over a hump: of first order, and the second is five times as close", "[water]") {
    const auto of_first = errors<ShallowWater>(calm(), 50, 200),
               of_second = errors<SecondOrderShallowWater>(calm(), 50, 200);
    CAPTURE(of_first, of_second);
    CHECK(of_first.back() <= 1e-2);
    CHECK(order(of_first) >= 0.95);
    for (std::size_t i = 0; i < 3; ++i) CHECK(5 * of_second[i] <= of_first[i]);
}

TEST_CASE("water that turns rapid on a hump: of first order, the second three times as close, and no step at the crest",
          "[water]") {
    const auto of_first = errors<ShallowWater>(rapid(), 50, 200),
               of_second = errors<SecondOrderShallowWater>(rapid(), 50, 200);
    CAPTURE(of_first, of_second);
    CHECK(of_first.back() <= 1e-2);
    CHECK(order(of_first) >= 0.95);
    for (std::size_t i = 0; i < 3; ++i) CHECK(3 * of_second[i] <= of_first[i]);
    // A scheme without the entropy of the exact one stands still at u = c and lets the level fall in a step there.
    const auto state = settled<ShallowWater>(rapid(), 200, 200);
    for (std::size_t i = 70; i < 90; ++i) { // 8.75 m to 11.25 m
        const double fall = state.height[i] + state.bed[i] - state.height[i + 1] - state.bed[i + 1];
        CHECK(fall > 0);
        CHECK(fall < 0.05); // of 0.5 m
    }
}

TEST_CASE("a jump behind a hump stands where momentum is kept", "[water]") {
    // As Trixi.jl's case of the same jump has it, where g is 9.812 m/s^2.
    CHECK(jump(9.812) == Approx(11.665504281554291).epsilon(0).margin(1e-9));
    const double at = jump();
    const auto of_first = errors<ShallowWater>(with_a_jump(), 50, 400, at),
               of_second = errors<SecondOrderShallowWater>(with_a_jump(), 50, 400, at);
    CAPTURE(of_first, of_second);
    CHECK(of_first.back() <= 1e-2);
    CHECK(order(of_first) >= 0.9);
    CHECK(of_second.back() <= of_first.back());
    for (const std::size_t count : {100U, 200U}) {
        const auto state = settled<ShallowWater>(with_a_jump(), count, 400);
        const double width = 25 / double(count);
        std::size_t i = std::size_t(11 / width); // rapid still
        while (state.height[i] + state.bed[i] < 0.25) ++i;
        CAPTURE(count, double(i) * width);
        CHECK(std::abs(double(i) * width - at) <= 1.5 * width);
    }
}

TEST_CASE("MacDonald's channel: what the bed gives is what friction takes", "[water]") {
    const auto of_first = errors<ShallowWater>(macdonald(), 50, 3000);
    CAPTURE(of_first);
    CHECK(of_first.back() <= 1e-2);
    CHECK(order(of_first) >= 0.85);
}
