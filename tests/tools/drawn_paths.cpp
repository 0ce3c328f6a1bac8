// SPDX-License-Identifier: BSL-1.0
// What a student sees of two paths: where they part, and both in letters.

#include "tests/catch.hpp"

#include "tools/exercises/drawn_paths.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

using namespace ansatz::workbook;

TEST_CASE("paths part at the first step that is farther off than the tolerance, or no number", "[tools]") {
    const std::vector<double> right{0, 1, 2, 3};
    CHECK(step_of_parting(right, right, 0) == 4);
    CHECK(step_of_parting({0, 1, 2.5, 3}, right, 0.4) == 2);
    CHECK(step_of_parting({0, 1, 2.5, 3}, right, 0.5) == 4);
    CHECK(step_of_parting({9, 1, 2, 3}, right, 1) == 0);
    CHECK(step_of_parting({0, NAN, 2, 3}, right, 1e9) == 1);
    CHECK(step_of_parting({0, 1, 2, std::numeric_limits<double>::infinity()}, right, 1e9) == 3);
}

TEST_CASE("two paths in letters", "[tools]") {
    // Both fall; yours falls half as fast after step 5.
    std::vector<double> yours, right;
    for (int n = 0; n <= 10; ++n) right.push_back(10 - n), yours.push_back(n <= 5 ? 10 - n : 7.5 - 0.5 * n);
    CHECK(drawn_paths(yours, right, 6, 0.1) == R"(        10 |*
           | *
           |  *
           |   *
           |    *
           |     *o
           |      +oo
           |       + oo
           |        +
           |         +
         0 |          +
           +------^----
            0       1 s
            o yours   + right   * both   ^ where they part
)");
}

TEST_CASE("a path that explodes does not press the right one flat, and no number is left out", "[tools]") {
    std::vector<double> yours, right;
    for (int n = 0; n <= 200; ++n) {
        right.push_back(std::sin(0.1 * n));
        yours.push_back(n < 50 ? right.back() : n < 100 ? -std::pow(2.0, n) : NAN);
    }
    const auto picture = drawn_paths(yours, right, 50, 0.01);
    CAPTURE(picture);
    std::size_t longest = 0, lines = 0, rows_of_right = 0;
    std::string line;
    for (const char c : picture) {
        if (c != '\n') {
            line += c;
            continue;
        }
        longest = std::max(longest, line.size());
        ++lines;
        rows_of_right += lines <= 11 && line.find_first_of("+*", 12) != std::string::npos;
        line.clear();
    }
    CHECK(longest <= 78);
    CHECK(lines == 14);
    CHECK(rows_of_right >= 6);                        // more than half of the height is the right path's
    CHECK(picture.find("-3 |") != std::string::npos); // one height of the right path below it, and no more
}

TEST_CASE("a path that stays where it is can be drawn", "[tools]") {
    for (const double y : {0.0, 5.0, -1e-30}) CHECK(drawn_paths({y, y}, {y, y}, 1, 1).find("**") != std::string::npos);
}
