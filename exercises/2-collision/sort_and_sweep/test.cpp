// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on sort and sweep (notes 2.1.1).

#include "tools/exercises/expect.hpp"

#include <ansatz/world.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <numeric>
#include <utility>

using namespace ansatz;
using namespace ansatz::workbook;

namespace {

using Point = VectorQuantity<unit::Length, 3>;
using Lengths = std::vector<Quantity<unit::Length>>;

/// A tower along an axis, with its foot at `foot`.
std::vector<Point> tower(int axis, const Point& foot) {
    std::vector<Point> points;
    for (int i = 0; i < 30; ++i) {
        Vector<double, 3> beside(0.25 * (i % 3), 0.25 * (i % 2), 0.125 * (i % 4));
        beside[axis] = i;
        points.push_back(foot + beside * metre);
    }
    return points;
}
/// A plate in x and y, and one body far above it.
std::vector<Point> plate() {
    std::vector<Point> points;
    for (int i = 0; i < 100; ++i) points.push_back(metres(i % 10, 2 * (i / 10), 0));
    points.push_back(metres(5, 5, 30));
    return points;
}
std::vector<Point> star() {
    return {metres(1, 0, 0), metres(-1, 0, 0), metres(0, 1, 0), metres(0, -1, 0), metres(0, 0, 1), metres(0, 0, -1)};
}

void expect_axis(const std::vector<Point>& points, int right, const std::string& what, const char* why) {
    const int yours = exercise::widest_axis(points);
    expect(yours == right, what + "\n    yours  axis " + std::to_string(yours) + "\n    right  axis " +
                               std::to_string(right) + "\n" + why);
}

std::string shown(const std::vector<std::size_t>& order) {
    std::string text;
    for (const std::size_t i : order) text += std::to_string(i) + " ";
    return text;
}
Lengths in_metres(const std::vector<double>& numbers) {
    Lengths lengths;
    for (const double x : numbers) lengths.push_back(x * metre);
    return lengths;
}
void expect_order(const std::vector<double>& lower, const std::vector<std::size_t>& right, const char* why) {
    const auto yours = exercise::sorted(in_metres(lower));
    std::string text = "bodies that begin at";
    for (const double x : lower) text += " " + ansatz::workbook::detail::shown(x);
    expect(yours == right,
           text + " m, in order\n    yours  " + shown(yours) + "\n    right  " + shown(right) + "\n" + why);
}

/// Bodies on a line, and what a pass along it makes of them.
struct Line {
    std::vector<double> lower, upper;

    std::vector<std::size_t> order() const {
        std::vector<std::size_t> all(lower.size());
        std::iota(all.begin(), all.end(), std::size_t(0));
        std::stable_sort(all.begin(), all.end(), [&](std::size_t a, std::size_t b) { return lower[a] < lower[b]; });
        return all;
    }
    std::vector<exercise::Pair> sweep(int& tests) const {
        return exercise::sweep(order(), in_metres(lower), in_metres(upper), [&] { ++tests; });
    }
    std::vector<exercise::Pair> yours() const {
        int tests = 0;
        auto pairs = sweep(tests);
        for (auto& [i, j] : pairs)
            if (i > j) std::swap(i, j); // that is another test's
        std::sort(pairs.begin(), pairs.end());
        return pairs;
    }
    std::vector<exercise::Pair> right() const {
        std::vector<exercise::Pair> pairs;
        for (std::size_t i = 0; i < lower.size(); ++i)
            for (std::size_t j = i + 1; j < lower.size(); ++j)
                if (lower[i] <= upper[j] && lower[j] <= upper[i]) pairs.emplace_back(i, j);
        return pairs;
    }
};
/// None share an end; a long one lies over several, and the list is in no order.
const std::vector<Line> lines{{{5, 0, 2.25, 9, 1, 7.5}, {6, 2, 3, 9.5, 8, 8.25}},
                              {{3, 2, 1, 0}, {3.75, 2.75, 1.75, 0.75}},
                              {{4, 0, 2, 1, 3}, {4.5, 9, 2.5, 1.5, 3.5}}};
const Line touching{{2, 0, 1, 4}, {3, 1, 2, 5}};

std::string said(const std::vector<exercise::Pair>& pairs) {
    std::string text;
    for (const auto& [i, j] : pairs) text += "(" + std::to_string(i) + ", " + std::to_string(j) + ") ";
    return text.empty() ? "none" : text;
}
void expect_pairs(const Line& line, const char* why) {
    std::string text = "bodies on a line:";
    for (std::size_t i = 0; i < line.lower.size(); ++i)
        text += " " + ansatz::workbook::detail::shown(line.lower[i]) + " to " +
                ansatz::workbook::detail::shown(line.upper[i]) + " m,";
    expect(line.yours() == line.right(),
           text + "\n    yours  " + said(line.yours()) + "\n    right  " + said(line.right()) + "\n" + why);
}

} // namespace

TEST_CASE("of a tower it is the axis along it", "[task-1][tower]") {
    for (int axis = 0; axis < 3; ++axis)
        expect_axis(tower(axis, metres(0, 0, 0)), axis, "a tower along axis " + std::to_string(axis),
                    "Along it the points are spread most.");
}

TEST_CASE("where the world lies does not matter", "[task-1][far-from-the-origin]") {
    for (int axis = 0; axis < 3; ++axis)
        for (const Point& foot : {metres(1000, 0, 0), metres(0, -1000, 0), metres(0, 0, 1000)})
            if (axis != 0 || component(foot, 0) == 0.0 * metre) {
                std::ostringstream what;
                what << "a tower along axis " << axis << " whose foot is at " << foot;
                const int yours = exercise::widest_axis(tower(axis, foot)),
                          at_home = exercise::widest_axis(tower(axis, metres(0, 0, 0)));
                expect(
                    yours == at_home,
                    what.str() + ": yours says axis " + std::to_string(yours) + ", and " + std::to_string(at_home) +
                        " when it stands at the origin\nIt is spread as much there as here: take the mean off first.");
            }
}

TEST_CASE("one body far away does not decide it", "[task-1][outlier]") {
    expect_axis(plate(), 1, "a plate, twice as long in y as in x, and one body far above it",
                "The variance counts them all; the one above adds less than the hundred others.");
}

TEST_CASE("of equal axes it is the first", "[task-1][equal-axes]") {
    expect_axis(star(), 0, "six points, two on each axis, as far apart",
                "Some axis must be agreed on, so that every run tells its pairs in one order.");
}

TEST_CASE("they stand in the order in which they begin", "[task-2][in-order]") {
    expect_order({3, 1, 2}, {1, 2, 0}, "Body 1 begins first, then body 2, then body 0.");
    expect_order({0.5, -4, 8, 2.5, -1}, {1, 4, 0, 3, 2}, "Body 1 begins first, and body 2 last.");
    expect_order({}, {}, "Of nobody there is no order.");
}

TEST_CASE("those that begin in one place stand by their index", "[task-2][ties]") {
    expect_order({1, 1, 1, 1}, {0, 1, 2, 3}, "They all begin in one place.");
    const auto order = exercise::sorted(in_metres({1, 0, 1, 0, 1, 0}));
    std::size_t before = 0;
    for (std::size_t p = 0; p < order.size(); ++p) {
        if (order[p] % 2 == 1) continue; // those at 1 m: 0, 2, 4
        expect(order[p] >= before, "bodies 0, 2 and 4 begin in one place, and stand in the order " + shown(order) +
                                       "\nOf equal ones the smaller index comes first.");
        before = order[p];
    }
}

TEST_CASE("every pair that overlaps is found, and no other", "[task-3][all-pairs]") {
    for (const Line& line : lines) expect_pairs(line, "From each body the pass goes on to where that body ends.");
}

TEST_CASE("bodies that share an end are a pair", "[task-3][shared-ends]") {
    expect_pairs(touching, "Ends belong to bodies: one begins where another ends.");
}

TEST_CASE("a pair is named with its smaller index first", "[task-3][smaller-first]") {
    for (const Line& line : lines) {
        int tests = 0;
        for (const auto& [i, j] : line.sweep(tests)) {
            std::ostringstream text;
            text << "yours names the pair (" << i << ", " << j
                 << "); the smaller index comes first, and nobody is paired with himself.";
            expect(i < j, text.str());
        }
    }
}

TEST_CASE("it tests few pairs", "[task-3][few-looks]") {
    Line row;
    for (int i = 0; i < 200; ++i)
        row.lower.push_back(199 - i), row.upper.push_back(200.5 - i); // each reaches over the next
    int tests = 0;
    row.sweep(tests);
    std::ostringstream text;
    text << "200 bodies in a row, each of which overlaps the next: yours tests " << tests
         << " pairs; all would be 19900, and 600 are enough."
         << "\nA body that begins after this one ends does not overlap it, and all that follow begin later still. "
            "(Call look() for each pair that you test.)";
    expect(tests <= 600, text.str());
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    if (task == 1) {
        for (int axis = 0; axis < 3; ++axis)
            numbers.push_back(exercise::widest_axis(tower(axis, metres(0, -1000, 0)))),
                numbers.push_back(exercise::widest_axis(tower(axis, metres(0, 0, 0))));
        numbers.push_back(exercise::widest_axis(plate()));
        numbers.push_back(exercise::widest_axis(star()));
    } else if (task == 2)
        for (const auto& lower : {std::vector<double>{3, 1, 2}, {0.5, -4, 8, 2.5, -1}, {1, 0, 1, 0, 1, 0}})
            for (const std::size_t i : exercise::sorted(in_metres(lower))) numbers.push_back(double(i));
    else {
        int tests = 0;
        for (const Line& line : {lines[0], lines[1], lines[2], touching}) {
            for (const auto& [i, j] : line.sweep(tests)) numbers.push_back(double(10 * i + j));
            numbers.push_back(-1);
        }
        numbers.push_back(tests > 26); // not how many: there are several good ways to count
    }
    return numbers;
}
