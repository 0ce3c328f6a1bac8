// SPDX-License-Identifier: BSL-1.0

// What docs/units.md shows, so that it is compiled and true.

#include "tests/catch.hpp"

#include <ansatz/units.hpp>
#include <ansatz/units/print.hpp>

#include <sstream>

using namespace ansatz;

TEST_CASE("the page about units shows what the library does", "[units][page]") {
    std::ostringstream out;
    //! [first]
    const auto g = metres_per_second_squared(0, -9.81, 0); // a vector: the plural
    const auto dt = 1.0 / 60 * second;                     // a number: the singular
    auto v = metres_per_second(3, 0, 0);
    v += g * dt;
    const auto height = 2.0 * metre + y(v) * dt;
    out << v << ", " << height;                   // (3, -0.1635, 0) m/s, 1.99727 m
    const double metres_only = in(height, metre); // out of the units, by name
    //! [first]
    CHECK(out.str() == "(3, -0.1635, 0) m/s, 1.99727 m"); // 2 - 9.81 / 3600
    CHECK(metres_only == height.value());
}
