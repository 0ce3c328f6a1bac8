// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on what a body displaces (notes 7.4).

#include "tools/exercises/expect.hpp"

#include <ansatz/world.hpp>

#include <cmath>

using namespace ansatz;
using namespace ansatz::workbook;

namespace {

struct Water {
    const char* name;
    std::vector<double> heights, footprints, parts; // m, m^2, 0 to 1

    exercise::Columns columns() const {
        exercise::Columns all;
        for (std::size_t n = 0; n < heights.size(); ++n)
            all.push_back({heights[n] * metre, footprints[n] * square_metre, parts[n]});
        return all;
    }
    double weight() const {
        double sum = 0;
        for (std::size_t n = 0; n < parts.size(); ++n) sum += parts[n] * footprints[n];
        return sum;
    }
    double share(std::size_t n) const { return parts[n] * footprints[n] / weight(); }
    double level() const {
        double sum = 0;
        for (std::size_t n = 0; n < parts.size(); ++n) sum += share(n) * heights[n];
        return sum;
    }
};
const Water waters[] = {
    {"a ring of four columns that are alike, and one beside it",
     {1.1, 0.9, 1.3, 1.2, 2.0},
     {1, 1, 1, 1, 1},
     {1, 1, 1, 1, 0}},
    {"a ring of columns of unequal footprints", {0.8, 1.4, 1.1}, {0.5, 2, 1.25}, {1, 1, 1}},
    {"a ring that fades at its edges", {1.2, 1.0, 0.7, 1.5, 1.3}, {1, 0.5, 2, 0.75, 3}, {0.25, 1, 1, 0.6, 0}},
};
const double volumes[] = {0.3, -0.12}; // m^3

std::string said(const Water& w, double volume) {
    std::ostringstream text;
    text << w.name << ", " << volume << " m^3 pressed up";
    return text.str();
}
auto shares(const Water& w) {
    const auto all = exercise::shares(w.columns());
    expect(all.size() == w.parts.size(), std::string(w.name) + ": there is one share for each column, and you return " +
                                             std::to_string(all.size()) + ".");
    return all;
}

} // namespace

TEST_CASE("the shares are one in sum", "[task-1][sum]") {
    for (const Water& w : waters) {
        double sum = 0;
        for (const double share : shares(w)) sum += share;
        expect_near(std::string(w.name) + ": the sum of the shares", sum, 1.0, 1e-12,
                    "All of the water goes somewhere, and none of it twice.");
    }
}

TEST_CASE("a share is in proportion to part and footprint", "[task-1][proportion]") {
    for (const Water& w : waters) {
        const auto all = shares(w);
        for (std::size_t n = 0; n < all.size(); ++n)
            expect_near(std::string(w.name) + ": the share of column " + std::to_string(n), all[n], w.share(n), 1e-12,
                        "A column of twice the footprint takes twice the water, and one that belongs to the ring by a "
                        "quarter, a quarter.");
    }
}

TEST_CASE("the water is all there", "[task-2][all-there]") {
    for (const Water& w : waters)
        for (const double volume : volumes) {
            auto columns = w.columns();
            exercise::press_up(columns, volume * cubic_metre);
            auto more = 0.0 * cubic_metre;
            for (std::size_t n = 0; n < columns.size(); ++n)
                more += (columns[n].height - w.heights[n] * metre) * columns[n].footprint;
            expect_near(said(w, volume) + ": by how much the columns hold more", more, volume * cubic_metre,
                        1e-12 * cubic_metre, "What the body displaces is what rises around it.");
        }
}

TEST_CASE("what belongs wholly to the ring rises alike", "[task-2][alike]") {
    for (const Water& w : waters)
        for (const double volume : volumes) {
            auto columns = w.columns();
            exercise::press_up(columns, volume * cubic_metre);
            for (std::size_t n = 0; n < columns.size(); ++n)
                expect_near(
                    said(w, volume) + ": by how much column " + std::to_string(n) + " rises",
                    columns[n].height - w.heights[n] * metre, w.parts[n] * volume / w.weight() * metre, 1e-12 * metre,
                    "Its share of the volume over its footprint: wide or narrow, all rise by the same height, and "
                    "less where the ring fades.");
        }
}

TEST_CASE("level water is as high as it is", "[task-3][level-water]") {
    for (Water w : waters) {
        for (double& h : w.heights) h = 1.7;
        expect_near(std::string(w.name) + ", all 1.7 m high: the level", exercise::level(w.columns()), 1.7 * metre,
                    1e-12 * metre, "The shares sum to 1.");
    }
}

TEST_CASE("each column counts by its share", "[task-3][by-share]") {
    for (const Water& w : waters)
        expect_near(std::string(w.name) + ": the level", exercise::level(w.columns()), w.level() * metre, 1e-12 * metre,
                    "A wide column says more of the level than a narrow one, and one that does not belong to the ring "
                    "says nothing.");
}

TEST_CASE("the level with what is displaced is the one by which it is displaced", "[task-4][both]") {
    for (const Water& w : waters)
        for (const double bottom : {0.2, 0.85}) {
            const double section = w.weight() / 3;
            const double volume = exercise::displaced(w.columns(), section * square_metre, bottom * metre).value();
            double level = w.level(); // with the water that rises
            for (std::size_t n = 0; n < w.parts.size(); ++n)
                level += w.share(n) * w.share(n) * volume / w.footprints[n];
            std::ostringstream text;
            text << w.name << ", a box of " << section << " m^2 with its bottom at " << bottom
                 << " m: its volume under water";
            expect_agree(text.str(), "yours", volume * cubic_metre, "section times depth, with yours pressed up",
                         section * (level - bottom) * cubic_metre, 1e-12 * cubic_metre,
                         "What it displaces rises and is read as level. The volume must be the one that goes with that "
                         "level, not with the one before.");
        }
}

TEST_CASE("above the water it displaces nothing", "[task-4][above]") {
    for (const Water& w : waters)
        expect_near(std::string(w.name) + ", a box that hangs a metre above: its volume under water",
                    exercise::displaced(w.columns(), 0.25 * w.weight() * square_metre, (w.level() + 1) * metre),
                    0.0 * cubic_metre, 1e-12 * cubic_metre, "A volume is not negative.");
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    for (const Water& w : waters) {
        auto columns = w.columns();
        if (task == 1)
            for (const double share : exercise::shares(columns)) numbers.push_back(share);
        if (task == 2) {
            exercise::press_up(columns, 0.3 * cubic_metre);
            for (const auto& c : columns) numbers.push_back(c.height.value());
        }
        if (task == 3) numbers.push_back(exercise::level(columns).value());
        if (task == 4)
            for (const double bottom : {0.2, 0.85, 3.0})
                numbers.push_back(exercise::displaced(columns, w.weight() / 3 * square_metre, bottom * metre).value());
    }
    return numbers;
}
