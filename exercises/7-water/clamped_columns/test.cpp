// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on a clamp that keeps the water (notes 7.2).

#include "tools/exercises/expect.hpp"

#include <ansatz/world.hpp>

#include <algorithm>
#include <cmath>

using namespace ansatz;
using namespace ansatz::workbook;

namespace {

struct Pool {
    const char* name;
    std::vector<double> heights, footprints; // m, m^2

    exercise::Columns columns() const {
        exercise::Columns all;
        for (std::size_t n = 0; n < heights.size(); ++n)
            all.push_back({heights[n] * metre, footprints[n] * square_metre});
        return all;
    }
    double volume() const {
        double sum = 0;
        for (std::size_t n = 0; n < heights.size(); ++n) sum += heights[n] * footprints[n];
        return sum;
    }
};
const double low = 0.5, high = 1.5; // m
const Pool pools[] = {
    {"a pool with one column too high", {1.0, 1.9, 0.8, 1.2}, {1, 0.5, 2, 0.25}},
    {"a pool with one column too low", {1.1, 0.2, 0.9, 1.3}, {0.7, 1.5, 1, 2}},
    {"a pool with columns beyond both limits", {1.7, 0.1, 1.1, 2.4, 0.7}, {0.5, 0.3, 1, 2, 1.5}},
    {"a pool in which what is spread fills a column", {2.5, 1.45, 0.6, 1.2}, {1.5, 2, 0.5, 4}},
    {"a pool in which what is taken back empties a column", {0.05, 0.52, 1.4, 0.7}, {2, 1, 0.4, 3}},
};
const Pool within{"a pool within the range", {1.0, 1.2, 0.6, 1.5}, {1, 0.5, 2, 0.7}};
const Pool flooded{"a pool with more water than it has room for", {1.4, 2.6, 1.3}, {1, 2, 0.5}};
const Pool drained{"a pool with less water than its columns must have", {0.6, 0.1, 0.55}, {1, 2, 0.5}};

std::string range() { return ", from 0.5 m to 1.5 m"; }
double total(const exercise::Columns& columns) {
    double sum = 0;
    for (const auto& c : columns) sum += c.height.value() * c.footprint.value();
    return sum;
}
void expect_in_range(const std::string& what, const exercise::Columns& columns) {
    for (std::size_t n = 0; n < columns.size(); ++n) {
        std::ostringstream text;
        text << what << ": column " << n << "\n    yours  " << columns[n].height << "\nIt must be in the range.";
        expect(columns[n].height >= (low - 1e-12) * metre && columns[n].height <= (high + 1e-12) * metre, text.str());
    }
}
/// The heights where so much is added to those that have room; by how much, found by halving.
std::vector<double> spread(const Pool& pool) {
    auto raised = [&](double by) {
        auto all = pool.heights;
        for (double& h : all) {
            h = std::clamp(h, low, high);
            h = std::clamp(h + by, low, high);
        }
        return all;
    };
    double least = low - high, most = high - low;
    for (int n = 0; n < 200; ++n) {
        const double by = (least + most) / 2;
        const auto all = raised(by);
        double sum = 0;
        for (std::size_t k = 0; k < all.size(); ++k) sum += all[k] * pool.footprints[k];
        (sum < pool.volume() ? least : most) = by;
    }
    return raised((least + most) / 2);
}

} // namespace

TEST_CASE("each column holds its height times its footprint", "[task-1][volume]") {
    for (const Pool& pool : pools)
        expect_near(std::string(pool.name) + ": its volume", exercise::volume(pool.columns()),
                    pool.volume() * cubic_metre, 1e-12 * cubic_metre,
                    "Footprints differ, so that they cannot be taken out of the sum.");
}

TEST_CASE("every height is in the range, and those that were stay", "[task-2][range]") {
    for (const auto* all : {&pools[0], &pools[1], &pools[2], &pools[3], &pools[4], &within}) {
        auto columns = all->columns();
        exercise::cut(columns, low * metre, high * metre);
        for (std::size_t n = 0; n < columns.size(); ++n) {
            std::ostringstream text;
            text << all->name << range() << ": the height of column " << n << ", which was " << all->heights[n] << " m";
            expect_near(text.str(), columns[n].height, std::clamp(all->heights[n], low, high) * metre, 1e-12 * metre,
                        "Beyond a limit it is the limit; within, nothing touches it.");
        }
    }
}

TEST_CASE("what is cut off is accounted for", "[task-2][account]") {
    for (const auto* all : {&pools[0], &pools[1], &pools[2], &pools[3], &pools[4], &within}) {
        auto columns = all->columns();
        const auto gone = exercise::cut(columns, low * metre, high * metre);
        expect_near(std::string(all->name) + range() + ": what was cut off above, less what was filled in below", gone,
                    (all->volume() - total(columns)) * cubic_metre, 1e-12 * cubic_metre,
                    "It is what the pool has lost: positive for what is gone, negative for what came from nowhere.");
    }
}

TEST_CASE("the pool holds what it held", "[task-3][kept]") {
    for (const Pool& pool : pools) {
        auto columns = pool.columns();
        const auto left = exercise::clamp(columns, low * metre, high * metre);
        expect_near(std::string(pool.name) + range() + ": what no column has room for", left, 0.0 * cubic_metre,
                    1e-12 * cubic_metre, "There is room enough in this pool.");
        expect_near(std::string(pool.name) + range() + ": its volume afterwards", total(columns) * cubic_metre,
                    pool.volume() * cubic_metre, 1e-12 * cubic_metre,
                    "What is cut off goes to the others, all of it. Where it fills one of them, the rest is spread "
                    "again.");
    }
}

TEST_CASE("and none leaves the range", "[task-3][in-range]") {
    for (const auto* pool : {&pools[0], &pools[1], &pools[2], &pools[3], &pools[4], &flooded, &drained}) {
        auto columns = pool->columns();
        exercise::clamp(columns, low * metre, high * metre);
        expect_in_range(std::string(pool->name) + range(), columns);
    }
}

TEST_CASE("all that have room rise by the same height", "[task-3][evenly]") {
    for (const Pool& pool : pools) {
        auto columns = pool.columns();
        exercise::clamp(columns, low * metre, high * metre);
        const auto right = spread(pool);
        for (std::size_t n = 0; n < columns.size(); ++n) {
            std::ostringstream text;
            text << pool.name << range() << ": the height of column " << n << ", which was " << pool.heights[n] << " m";
            expect_near(text.str(), columns[n].height, right[n] * metre, 1e-9 * metre,
                        "The volume, over the footprints of all that have room, is by how much each of them rises; a "
                        "column at the limit has none.");
        }
    }
}

TEST_CASE("what no column has room for is returned", "[task-3][no-room]") {
    for (const Pool* pool : {&flooded, &drained}) {
        auto columns = pool->columns();
        const auto left = exercise::clamp(columns, low * metre, high * metre);
        double right = pool->volume();
        for (const double f : pool->footprints) right -= f * (pool == &flooded ? high : low);
        expect_near(std::string(pool->name) + range() + ": what is returned", left, right * cubic_metre,
                    1e-12 * cubic_metre,
                    "All columns are at the limit then, and what is left is neither in the pool nor forgotten.");
    }
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    for (const auto* pool : {&pools[0], &pools[1], &pools[2], &pools[3], &pools[4], &within, &flooded, &drained}) {
        auto columns = pool->columns();
        if (task == 1) {
            numbers.push_back(exercise::volume(columns).value());
            continue;
        }
        numbers.push_back((task == 2 ? exercise::cut(columns, low * metre, high * metre)
                                     : exercise::clamp(columns, low * metre, high * metre))
                              .value());
        for (const auto& c : columns) numbers.push_back(c.height.value());
    }
    return numbers;
}
