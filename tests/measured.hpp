// SPDX-License-Identifier: BSL-1.0
#pragma once

// What a test of a hard case measured, told in one line that `./workbook cases` reads from ctest's log:
//
//     CHECK(test::measured("C1", "momentum that is lost", lost, test::at_most(4e-15), "kg m/s"));
//
// The bound that is told is the one that is checked, so that no page shows another. Take it where a row has a number of
// its own; what is asserted besides stays a plain CHECK.

#include <cstdio>
#include <limits>
#include <string>

namespace ansatz::test {

/// From `lowest` to `highest`, both allowed.
struct Bound {
    double lowest, highest;
};
inline Bound at_most(double highest) { return {-std::numeric_limits<double>::infinity(), highest}; }
inline Bound at_least(double lowest) { return {lowest, std::numeric_limits<double>::infinity()}; }
inline Bound between(double lowest, double highest) { return {lowest, highest}; }
inline Bound about(double value, double margin) { return {value - margin, value + margin}; }

/// Prints what was measured for a row of tests/hard_cases.txt, and says whether it is within its bound: a NaN is not.
[[nodiscard]] inline bool measured(const std::string& row, const std::string& what, double value, Bound bound,
                                   const std::string& unit = "") {
    const auto text = [](double number) {
        char digits[32];
        std::snprintf(digits, sizeof digits, "%.7g", number);
        return std::string(digits);
    };
    constexpr double infinite = std::numeric_limits<double>::infinity();
    const bool held = value >= bound.lowest && value <= bound.highest;
    const std::string told = bound.lowest == -infinite   ? "<= " + text(bound.highest)
                             : bound.highest == infinite ? ">= " + text(bound.lowest)
                                                         : text(bound.lowest) + " to " + text(bound.highest);
    std::printf("\nmeasured | %s | %s | %s | %s | %s | %s\n", row.c_str(), what.c_str(), text(value).c_str(),
                told.c_str(), unit.c_str(), held ? "held" : "broken");
    std::fflush(stdout);
    return held;
}

} // namespace ansatz::test
