// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on a sheet of bodies and springs (notes 4).

#include "tools/exercises/expect.hpp"

#include <ansatz/world.hpp>

#include <algorithm>
#include <cmath>

using namespace ansatz;
using namespace ansatz::workbook;

namespace {

using exercise::Sheet;

const Sheet sheets[] = {{4, 3, 1.5 * metre, 0.8 * metre},
                        {3, 5, 0.6 * metre, 2.0 * metre},
                        {2, 2, 0.3 * metre, 0.4 * metre},
                        {6, 6, 2.5 * metre, 1.0 * metre}};
std::string said(const Sheet& s) {
    std::ostringstream text;
    text << "a sheet of " << s.columns << " columns and " << s.rows << " rows, " << s.width << " by " << s.height;
    return text.str();
}
int column(const Sheet& s, int v) { return v % s.columns; }
int row(const Sheet& s, int v) { return v / s.columns; }

/// The smaller vertex first, and all of them in order.
exercise::Springs sorted(exercise::Springs all) {
    for (auto& [a, b] : all)
        if (b < a) std::swap(a, b);
    std::sort(all.begin(), all.end());
    return all;
}
/// All pairs of vertices of which it is true that they are so many columns and rows apart.
template <class Apart> exercise::Springs all_pairs(const Sheet& s, const Apart& apart) {
    exercise::Springs all;
    for (int a = 0; a < s.columns * s.rows; ++a)
        for (int b = a + 1; b < s.columns * s.rows; ++b)
            if (apart(std::abs(column(s, b) - column(s, a)), std::abs(row(s, b) - row(s, a)))) all.emplace_back(a, b);
    return all;
}
void expect_springs(const std::string& what, const Sheet& s, const exercise::Springs& yours,
                    const exercise::Springs& right, const std::string& why) {
    const auto mine = sorted(yours);
    for (const auto& [a, b] : mine)
        if (a < 0 || b >= s.columns * s.rows)
            fail(what + "\nYours has one between " + std::to_string(a) + " and " + std::to_string(b) + "; there are " +
                 std::to_string(s.columns * s.rows) + " vertices, from 0.");
    auto say = [&](const std::pair<int, int>& spring, const char* how) {
        std::ostringstream text;
        text << what << "\nThe one between vertex " << spring.first << " (column " << column(s, spring.first)
             << ", row " << row(s, spring.first) << ") and vertex " << spring.second << " (column "
             << column(s, spring.second) << ", row " << row(s, spring.second) << ") " << how << ".\n"
             << why;
        fail(text.str());
    };
    for (const auto& spring : mine)
        if (!std::binary_search(right.begin(), right.end(), spring)) say(spring, "is in yours and should not be");
    for (const auto& spring : right)
        if (!std::binary_search(mine.begin(), mine.end(), spring)) say(spring, "is not in yours");
    const auto twice = std::adjacent_find(mine.begin(), mine.end());
    if (twice != mine.end()) say(*twice, "is in yours twice");
}

} // namespace

TEST_CASE("structural springs join neighbours", "[task-1][structural]") {
    for (const Sheet& s : sheets)
        expect_springs(said(s) + ": the springs along its lines, to the next vertex", s, exercise::along(s, 1),
                       all_pairs(s, [](int i, int j) { return i + j == 1; }),
                       "Two vertices that are one apart in a row or in a column are joined, each pair once.");
}

TEST_CASE("bend springs join each vertex with the next but one", "[task-1][bend]") {
    for (const Sheet& s : sheets)
        expect_springs(
            said(s) + ": the springs along its lines, two vertices farther", s, exercise::along(s, 2),
            all_pairs(s, [](int i, int j) { return (i == 2 && j == 0) || (i == 0 && j == 2); }),
            "In a row or in a column, and never around the end of one: the last vertex of a row has the next "
            "number to the first of the next row, and is far from it.");
}

TEST_CASE("each cell has both diagonals", "[task-2][diagonals]") {
    for (const Sheet& s : sheets)
        expect_springs(said(s) + ": the springs across its cells", s, exercise::diagonals(s),
                       all_pairs(s, [](int i, int j) { return i == 1 && j == 1; }),
                       "One column and one row apart, on both diagonals: with one of them the sheet gives way to one "
                       "side and not to the other.");
}

TEST_CASE("along a row and along a column the cells are as wide as they are", "[task-3][sides]") {
    for (const Sheet& s : sheets)
        for (const auto& [a, b] : all_pairs(s, [](int i, int j) { return i + j == 1; })) {
            std::ostringstream text;
            text << said(s) << ": the rest length between vertices " << a << " and " << b;
            const auto right = row(s, a) == row(s, b) ? s.width / double(s.columns - 1) : s.height / double(s.rows - 1);
            const char* why = "Of n vertices in a row, the first and the last lie on the sides: there are n - 1 cells "
                              "between them.";
            expect_near(text.str(), exercise::rest_length(s, a, b), right, 1e-12 * metre, why);
            expect_near(text.str() + ", the other way round", exercise::rest_length(s, b, a), right, 1e-12 * metre,
                        why);
        }
}

TEST_CASE("across a cell it is Pythagoras", "[task-3][across]") {
    for (const Sheet& s : sheets)
        for (const auto& [a, b] : all_pairs(s, [](int i, int j) { return i == j || i == 2 * j; })) {
            const double dx = s.width.value() / (s.columns - 1) * (column(s, b) - column(s, a)),
                         dy = s.height.value() / (s.rows - 1) * (row(s, b) - row(s, a));
            std::ostringstream text;
            text << said(s) << ": the rest length between vertices " << a << " and " << b;
            expect_near(text.str(), exercise::rest_length(s, a, b), std::sqrt(dx * dx + dy * dy) * metre, 1e-12 * metre,
                        "At rest a spring is as long as its ends are apart. Cells need not be square, so that a "
                        "diagonal is not the root of 2 times a side.");
        }
}

TEST_CASE("the masses add up to that of the sheet", "[task-4][sum]") {
    for (const Sheet& s : sheets) {
        auto sum = 0.0 * kilogram;
        for (int v = 0; v < s.columns * s.rows; ++v) sum += exercise::mass(s, v, 0.2 * kilogram / square_metre);
        expect_near(said(s) + ", 0.2 kg/m^2: the sum of all masses", sum,
                    0.2 * kilogram / square_metre * (s.width * s.height), 1e-12 * kilogram,
                    "Each bit of the sheet belongs to one vertex, and to one alone.");
    }
}

TEST_CASE("a vertex has the quarters of its cells", "[task-4][quarters]") {
    for (const Sheet& s : sheets) {
        std::vector<double> quarters(std::size_t(s.columns * s.rows));
        for (int j = 0; j + 1 < s.rows; ++j)
            for (int i = 0; i + 1 < s.columns; ++i)
                for (const int v : {i, i + 1, i + s.columns, i + 1 + s.columns}) quarters[v + s.columns * j] += 0.25;
        const auto cell = s.width * s.height / double((s.columns - 1) * (s.rows - 1));
        for (int v = 0; v < s.columns * s.rows; ++v) {
            std::ostringstream text;
            text << said(s) << ", 0.7 kg/m^2: the mass of vertex " << v << ", in column " << column(s, v) << ", row "
                 << row(s, v);
            expect_near(text.str(), exercise::mass(s, v, 0.7 * kilogram / square_metre),
                        0.7 * kilogram / square_metre * (quarters[v] * cell), 1e-12 * kilogram,
                        "Inside it has a quarter of four cells, on a side of two, in a corner of one.");
        }
    }
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    for (const Sheet& s : sheets) {
        auto add = [&](const exercise::Springs& springs) {
            for (const auto& [a, b] : sorted(springs)) numbers.insert(numbers.end(), {1.0 + a, 1.0 + b});
            numbers.push_back(1000);
        };
        if (task == 1)
            for (const int by : {1, 2}) add(exercise::along(s, by));
        if (task == 2) add(exercise::diagonals(s));
        for (int v = 0; v < s.columns * s.rows; ++v) {
            if (task == 3) numbers.push_back(exercise::rest_length(s, v, (2 * v + 1) % (s.columns * s.rows)).value());
            if (task == 4) numbers.push_back(exercise::mass(s, v, 0.7 * kilogram / square_metre).value());
        }
    }
    return numbers;
}
