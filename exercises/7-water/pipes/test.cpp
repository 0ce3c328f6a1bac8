// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on a flow that takes no more than there is (notes 7.2).

#include "tools/exercises/expect.hpp"

#include <ansatz/world.hpp>

#include <algorithm>
#include <cmath>

using namespace ansatz;
using namespace ansatz::workbook;

namespace {

struct One {
    double bed, height, length; // m

    exercise::Column column() const { return {bed * metre, height * metre, length * metre}; }
    double level() const { return bed + height; }
};
const auto flow_unit = cubic_metre / second;
const double across = 1.7, g = 3.7, damping = 0.9, dt = 0.04; // m, m/s^2, 1/s, s

struct Pair {
    One here, there;
    double flow; // m^3/s
};
const Pair pairs[] = {{{0.2, 1.3, 0.8}, {0.5, 0.7, 1.4}, 0.3},
                      {{0.9, 0.4, 1.1}, {-0.3, 1.9, 0.6}, -0.2},
                      {{-0.5, 2.1, 0.5}, {0.6, 0.3, 0.9}, 1.1},
                      {{1.2, 0.6, 1.6}, {0.1, 0.8, 0.7}, -0.7}};
const Pair shore{{0.1, 0.6, 0.8}, {1.5, 0, 1.3}, 0.4}; // the ground of the second is above the water
std::string said(const Pair& p) {
    std::ostringstream text;
    text << "beds of " << p.here.bed << " and " << p.there.bed << " m, heights of " << p.here.height << " and "
         << p.there.height << " m";
    return text.str();
}
/// Counted in slices of a tenth of a millimetre that are above both beds, and not above both levels.
double depth_of(const Pair& p) {
    int slices = 0;
    for (int k = -20000; k < 40000; ++k) {
        const double y = (k + 0.5) * 1e-4;
        if (y > p.here.bed && y > p.there.bed && (y < p.here.level() || y < p.there.level())) ++slices;
    }
    return slices * 1e-4;
}
auto next_flow(const Pair& p, double lost = damping, double seconds = dt) {
    return exercise::next_flow(p.flow * flow_unit, p.here.column(), p.there.column(), across * metre,
                               g * metre_per_second_squared, lost * hertz, seconds * second);
}
double way(const Pair& p) { return (p.here.length + p.there.length) / 2; }

struct Leaving {
    One of;
    double west, east; // m^3/s
};
const Leaving short_of[] = {
    {{0.4, 0.3, 0.7}, -6, 8}, {{-0.2, 0.05, 1.2}, 3, 7}, {{0.1, 0.02, 0.9}, -2, -5}, {{0, 0, 1.1}, -0.6, 0.9}};
const Leaving enough[] = {{{0.4, 1.3, 0.7}, -0.6, 0.8}, {{-0.2, 0.9, 1.2}, 20, 2}, {{0.1, 0.5, 0.9}, -1.5, -30},
                          {{0.3, 0.2, 0.6}, 40, -40},   {{0, 0, 1.1}, 0.6, -0.9},  {{0.7, 0.4, 1.3}, 0, 0}};
std::string said(const Leaving& l) {
    std::ostringstream text;
    text << "a column of " << l.of.height << " m on " << l.of.length << " m by " << across << " m, a step of " << dt
         << " s, " << l.west << " m^3/s through its western face and " << l.east
         << " m^3/s through its eastern one: the part that may leave";
    return text.str();
}
double part(const Leaving& l) {
    return exercise::part(l.of.column(), l.west * flow_unit, l.east * flow_unit, across * metre, dt * second);
}
double wants(const Leaving& l) { return (std::max(0.0, l.east) + std::max(0.0, -l.west)) * dt; }

exercise::Channel channel(const std::vector<One>& columns, std::vector<double> flows = {}) {
    exercise::Channel all{{}, {}, across * metre};
    flows.resize(columns.size() - 1, 0.0);
    for (const One& c : columns) all.columns.push_back(c.column());
    for (const double q : flows) all.flows.push_back(q * flow_unit);
    return all;
}
void step(exercise::Channel& all, double lost = damping, double seconds = dt) {
    exercise::step(all, g * metre_per_second_squared, lost * hertz, seconds * second);
}
double volume(const exercise::Channel& all) {
    double sum = 0;
    for (const auto& c : all.columns) sum += c.height.value() * c.length.value() * across;
    return sum;
}
/// A slope of short and of long columns, the upper of which hold water and the lower none.
const std::vector<One> hill = {{2.0, 0.8, 0.3}, {1.9, 0.5, 1.5}, {1.2, 0.3, 0.2}, {0.9, 0.0, 1.8},
                               {0.4, 0.1, 0.4}, {0.0, 0.0, 1.2}, {0.3, 0.0, 0.6}, {1.1, 0.0, 0.9}};
const std::vector<One> basin = {{0.3, 1.2, 0.8}, {0.1, 1.1, 0.5}, {-0.2, 1.5, 0.9}, {0.4, 0.6, 1.3}};
/// That in the middle loses to both sides more than it has.
const std::vector<One> spring = {{0, 0.1, 1.1}, {2.0, 0.05, 0.4}, {0.2, 0.2, 0.7}};
const std::vector<double> from_spring = {-0.6, 0.5};

} // namespace

TEST_CASE("from the higher bed up to the higher level", "[task-1][depth]") {
    for (const Pair& p : pairs)
        expect_near(said(p) + ": the depth at the face", exercise::depth(p.here.column(), p.there.column()),
                    depth_of(p) * metre, 2e-4 * metre,
                    "Water passes where it stands above the ground of both columns, as high as it stands in one of "
                    "them.");
}

TEST_CASE("from either side it is the same", "[task-1][sides]") {
    for (const Pair& p : pairs)
        expect_agree(said(p) + ": the depth at the face", "from here to there",
                     exercise::depth(p.here.column(), p.there.column()), "from there to here",
                     exercise::depth(p.there.column(), p.here.column()), 1e-12 * metre, "It is one face.");
}

TEST_CASE("where dry ground is above the water, there is none at the face", "[task-1][shore]") {
    expect_near(said(shore) + ": the depth at the face", exercise::depth(shore.here.column(), shore.there.column()),
                0.0 * metre, 1e-12 * metre, "The level of a dry column is its ground.");
}

TEST_CASE("what ran before and what the levels push, damped", "[task-2][push]") {
    for (const Pair& p : pairs) {
        const double d = std::max(p.here.level(), p.there.level()) - std::max(p.here.bed, p.there.bed);
        const double pushed = g * across * d * (p.here.level() - p.there.level()) / way(p) * dt;
        expect_near(said(p) + ": the flow after a step", next_flow(p),
                    (p.flow + pushed) * std::exp(-damping * dt) * flow_unit, 1e-9 * flow_unit,
                    "g times across times depth times the difference of levels, over the way between the centres, for "
                    "dt; then all of it is damped.");
    }
}

TEST_CASE("between equal levels it is damped alone, the same in a second at any rate", "[task-2][rates]") {
    for (const double rate : {5.0, 30.0, 240.0}) {
        Pair level{{0.2, 1.3, 0.8}, {0.6, 0.9, 1.4}, 0.3};
        for (int n = 0; n < int(rate); ++n) level.flow = next_flow(level, damping, 1 / rate).value();
        expect_near("a flow of 0.3 m^3/s between equal levels, after a second", level.flow * flow_unit,
                    0.3 * std::exp(-damping) * flow_unit, 1e-9 * flow_unit,
                    "Damping is given per second, and equal levels do not push, whatever the heights are.");
    }
}

TEST_CASE("no water passes more than the way in a step", "[task-2][most]") {
    for (Pair p : pairs) {
        const double d = std::max(p.here.level(), p.there.level()) - std::max(p.here.bed, p.there.bed);
        for (const double sign : {1.0, -1.0}) {
            p.flow = sign * 1e4;
            // From the side with the higher level, short of nothing.
            p.here.length = p.there.length = 0.9;
            if ((p.here.level() > p.there.level()) != (sign > 0)) continue;
            expect_near(said(p) + ": the flow after a step, where far more ran before", next_flow(p),
                        sign * across * d * 0.9 / dt * flow_unit, 1e-9 * across * d / dt * flow_unit,
                        "What stands in the face, times the way, over the step; to either side.");
        }
    }
}

TEST_CASE("nothing passes where nothing stands in the face", "[task-2][dry]") {
    expect_near(said(shore) + ": the flow after a step, where 0.4 m^3/s ran before", next_flow(shore), 0.0 * flow_unit,
                1e-12 * flow_unit, "Without depth the most that can pass is nothing.");
}

TEST_CASE("who has enough gives all", "[task-3][enough]") {
    for (const Leaving& l : enough)
        expect_near(said(l), part(l), 1.0, 1e-9,
                    "What runs in does not leave, and more than all of what wants to leave does not leave either.");
}

TEST_CASE("who has less gives what there is", "[task-3][short]") {
    for (const Leaving& l : short_of)
        expect_near(said(l), part(l), l.of.height * l.of.length * across / wants(l), 1e-9,
                    "The volume that is there, over the volume that leaves in a step through both faces.");
}

TEST_CASE("a hair less than nothing is nothing", "[task-3][rounding]") {
    for (const double out : {0.0, 0.7}) {
        const Leaving l{{0.3, -1e-17, 0.9}, -out, 2 * out};
        expect_near(said(l), part(l), out > 0 ? 0.0 : 1.0, 1e-9,
                    "By rounding a column that gives all it has may be left with less than nothing. It has nothing to "
                    "give then; and where nothing wants to leave, all of that may.");
    }
}

TEST_CASE("heights move by what the faces let pass, pushed by the heights before", "[task-4][together]") {
    auto all = channel(basin, {0.2, -0.1, 0.3});
    const auto before = all;
    step(all);
    for (std::size_t i = 0; i < all.flows.size(); ++i) {
        std::ostringstream text;
        text << "the flow from column " << i << " to " << i + 1;
        expect_near(text.str(), all.flows[i], next_flow({basin[i], basin[i + 1], before.flows[i].value()}),
                    1e-12 * flow_unit, "All flows come from the heights before the step; here all have enough.");
    }
    for (std::size_t i = 0; i < basin.size(); ++i) {
        const double in = (i > 0 ? all.flows[i - 1].value() : 0) - (i + 1 < basin.size() ? all.flows[i].value() : 0);
        std::ostringstream text;
        text << "the height of column " << i << " after a step";
        expect_near(text.str(), all.columns[i].height, (basin[i].height + in * dt / (basin[i].length * across)) * metre,
                    1e-12 * metre, "What runs in less what runs out, for dt, over the column's own footprint.");
    }
}

TEST_CASE("who gives all it has is dry, and both sides get their share", "[task-4][share]") {
    auto all = channel(spring, from_spring);
    step(all);
    const double has = spring[1].height * spring[1].length * across,
                 wanted_west = -next_flow({spring[0], spring[1], -0.6}).value(),
                 wanted_east = next_flow({spring[1], spring[2], 0.5}).value();
    const double all_wanted = wanted_west + wanted_east;
    expect_near("the height of a column from which more wants to leave than there is", all.columns[1].height,
                0.0 * metre, 1e-12 * metre, "It gives what it has, no more and no less.");
    expect_near("the flow to its west, as it is kept", all.flows[0], -has / dt * wanted_west / all_wanted * flow_unit,
                1e-9 * flow_unit, "Both flows out are made smaller by the same part, and stay so.");
    expect_near("the flow to its east, as it is kept", all.flows[1], has / dt * wanted_east / all_wanted * flow_unit,
                1e-9 * flow_unit, "Both flows out are made smaller by the same part, and stay so.");
}

TEST_CASE("down a hill no water is lost and no height is negative", "[task-4][kept]") {
    auto all = channel(hill);
    const double before = volume(all);
    for (int n = 0; n < 400; ++n) {
        step(all);
        for (const auto& c : all.columns) {
            std::ostringstream text;
            text << "after " << n + 1 << " steps a column holds\n    yours  " << c.height
                 << "\nNo column gives more than it has.";
            expect(c.height >= -1e-12 * metre, text.str());
        }
    }
    expect_near("the volume of all columns after 400 steps", volume(all) * cubic_metre, before * cubic_metre,
                1e-9 * cubic_metre, "What leaves one column enters the next.");
}

TEST_CASE("a lake with an island is at rest", "[task-4][lake]") {
    const std::vector<One> lake = {{0.2, 0.8, 0.7}, {0.7, 0.3, 1.2}, {1.4, 0, 0.5}, {-0.3, 1.3, 0.9}, {0.5, 0.5, 0.4}};
    auto all = channel(lake);
    for (int n = 0; n < 100; ++n) step(all);
    for (std::size_t i = 0; i < lake.size(); ++i) {
        std::ostringstream text;
        text << "the height of column " << i << " of a lake after 100 steps";
        expect_near(text.str(), all.columns[i].height, lake[i].height * metre, 1e-12 * metre,
                    "All wet columns have one level, and the island is above it: nothing pushes.");
    }
}

TEST_CASE("east and west are alike", "[task-4][mirror]") {
    auto mirrored = hill;
    std::reverse(mirrored.begin(), mirrored.end());
    auto all = channel(hill), other = channel(mirrored);
    for (int n = 0; n < 40; ++n) {
        step(all);
        step(other);
    }
    for (std::size_t i = 0; i < hill.size(); ++i) {
        std::ostringstream text;
        text << "the height of column " << i << " of a hill after 40 steps";
        expect_agree(text.str(), "with the hill in the west", all.columns[i].height, "with the hill in the east",
                     other.columns[hill.size() - 1 - i].height, 1e-9 * metre,
                     "No column comes first: all flows are known before a height moves.");
    }
}

TEST_CASE("a level basin swings once in 2 L / sqrt(g d)", "[task-4][seiche]") {
    const int count = 40;
    std::vector<One> flat;
    for (int i = 0; i < count; ++i)
        flat.push_back({0.3, 1.1 + 0.01 * std::cos(std::acos(-1.0) * (i + 0.5) / count), 0.25});
    auto all = channel(flat);
    double crossings = 0, last = 0.01, period = 0;
    for (int n = 1; n < 2000 && crossings < 3; ++n) {
        step(all, 0.0, 0.02);
        const double now = all.columns[0].height.value() - 1.1;
        if ((now < 0) != (last < 0)) {
            ++crossings;
            const double at = 0.02 * (n - now / (now - last));
            if (crossings == 1) period = -at;
            if (crossings == 3) period += at;
        }
        last = now;
    }
    const double right = 2 * count * 0.25 / std::sqrt(g * 1.1);
    expect_near("the period of a basin of 10 m, 1.1 m deep, g = 3.7 m/s^2", (crossings < 3 ? 0 : period) * second,
                right * second, 5e-3 * right * second, "Its waves run at sqrt(g d), to and fro.");
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    auto add = [&](const auto& quantity) { numbers.push_back(quantity.value()); };
    if (task <= 2)
        for (Pair p : {pairs[0], pairs[1], pairs[2], pairs[3], shore}) {
            if (task == 1) {
                add(exercise::depth(p.here.column(), p.there.column()));
                add(exercise::depth(p.there.column(), p.here.column()));
                continue;
            }
            add(next_flow(p));
            p.here.length = p.there.length = 0.9;
            p.flow = p.here.level() > p.there.level() ? 1e4 : -1e4;
            add(next_flow(p));
        }
    if (task == 3) {
        for (const Leaving& l : short_of) numbers.push_back(part(l));
        for (const Leaving& l : enough) numbers.push_back(part(l));
        numbers.push_back(part({{0.3, -1e-17, 0.9}, 0, 0}));
    }
    if (task == 4) {
        auto one = channel(basin, {0.2, -0.1, 0.3}), two = channel(spring, from_spring), three = channel(hill);
        for (auto* all : {&one, &two, &three})
            for (int n = 0; n < 3; ++n) {
                step(*all);
                for (const auto& c : all->columns) add(c.height);
                for (const auto& q : all->flows) add(q);
            }
    }
    return numbers;
}
