// SPDX-License-Identifier: BSL-1.0
// Quantities in streams.

#include "tests/catch.hpp"

#include "tests/units/spaces.hpp"

#include <ansatz/units/print.hpp>

#include <boost/units/io.hpp> // its operator<< must not get in the way

#include <iomanip>
#include <sstream>

using namespace ansatz;
using namespace ansatz::test;

namespace {
template <class... Things> std::string printed(const Things&... things) {
    std::ostringstream out;
    (out << ... << things);
    return out.str();
}
} // namespace

TEST_CASE("a quantity prints with its unit", "[units]") {
    CHECK(printed(2.0 * kilogram) == "2 kg");
    CHECK(printed(metres(0, 9.5, 0)) == "(0, 9.5, 0) m");
    CHECK(printed(metres_per_second(1, -2)) == "(1, -2) m/s");
    CHECK(printed(1 * metre / (2 * metre)) == "0.5");
    CHECK(printed(MatrixQuantity<unit::Stiffness, 2>()) == "((0, 0), (0, 0)) N/m");
    CHECK(printed(scalar_cast<float>(metres(0.5, 1))) == "(0.5, 1) m");
    CHECK(printed(Precise(0.5) * metre) == "0.5 m");
    CHECK(printed(metres(Precise(0.5), 1)) == "(0.5, 1) m");
    struct Drag {
        Parameter<unit::Frequency> rate;
    };
    CHECK(printed(Drag{0.05 / second}.rate) == "0.05 1/s");
}

TEST_CASE("the stream's format is honoured and left as it was", "[units]") {
    CHECK(printed(std::setprecision(3), 3.14159 * metre) == "3.14 m");
    CHECK(printed(std::fixed, std::setprecision(2), metres(1, 2.5, -3)) == "(1.00, 2.50, -3.00) m");
    CHECK(printed(std::setw(6), 2.5 * metre, '|') == "   2.5 m|");
    CHECK(printed(std::setw(5), metres(1, 2), '|') == "(    1,     2) m|");
    CHECK(printed(std::setw(5), std::left, metres(1, 2)) == "(1    , 2    ) m");
    CHECK(printed(std::setw(5), 1 * metre, 2) == "    1 m2"); // a width lasts for one quantity
    std::wostringstream wide;
    wide << metres(1, 2);
    CHECK(wide.str() == L"(1, 2) m");
}
