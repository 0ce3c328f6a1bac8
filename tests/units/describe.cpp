// SPDX-License-Identifier: BSL-1.0
// Quantities as text for sentences.

#include <ansatz/units/describe.hpp>

#include "tests/catch.hpp"

#include "tests/units/spaces.hpp"

#include <cstdlib>
#include <limits>
#include <string>

using namespace ansatz;
using namespace ansatz::test;

TEST_CASE("describe writes value and symbol", "[units]") {
    CHECK(describe(-3 * kilogram) == "-3 kg");
    CHECK(describe(0.1 * metre) == "0.1 m");
    CHECK(describe(0.1f * metre) == "0.1 m");
    CHECK(describe(metres(0, 9.5, 0)) == "(0, 9.5, 0) m");
    CHECK(describe(metres_per_second(-1, 0.25)) == "(-1, 0.25) m/s");
    CHECK(describe(scalar_cast<float>(metres(0.1, 0.2))) == "(0.1, 0.2) m");
    CHECK(describe(2 * joule) == "2 J");
    CHECK(describe((1 * metre) / (2 * metre)) == "0.5");
    CHECK(describe(0.5) == "0.5");
    CHECK(describe(7) == "7");
    CHECK(describe(Eigen::Vector3d(0, 1, 0)) == "(0, 1, 0)");
    CHECK(describe(MatrixQuantity<unit::Stiffness, 2>()) == "((0, 0), (0, 0)) N/m");
    Eigen::Matrix2d m;
    m << 1, 2, 3, 4;
    CHECK(describe(m * newton_per_metre) == "((1, 2), (3, 4)) N/m");
    CHECK(describe(Precise(0.5) * metre) == "0.5 m");
    CHECK(describe(metres(Precise(0.5), 2)) == "(0.5, 2) m");
}

TEST_CASE("describe names what is not finite", "[units]") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double inf = std::numeric_limits<double>::infinity();
    CHECK(describe(nan * metre) == "nan m");
    CHECK(describe(-nan * metre) == "nan m");
    CHECK(describe(inf * kilogram) == "inf kg");
    CHECK(describe(-inf * kilogram) == "-inf kg");
    CHECK(describe(metres(0, nan, inf)) == "(0, nan, inf) m");
    CHECK(describe(-0.0 * metre) == "-0 m");
}

TEMPLATE_TEST_CASE("a described number reads back as itself", "[units]", float, double) {
    using S = TestType;
    std::mt19937_64 engine(7);
    for (int n = 0; n < 1000; ++n) {
        const S value = std::ldexp(S(std::uniform_real_distribution<double>(-1, 1)(engine)),
                                   static_cast<int>(engine() % 200) - 100);
        const std::string text = describe(value * metre);
        CHECK(static_cast<S>(std::is_same_v<S, float> ? std::strtof(text.c_str(), nullptr)
                                                      : std::strtod(text.c_str(), nullptr)) == value);
        CHECK(text.size() <= (std::is_same_v<S, float> ? 15u : 24u) + 2u);
    }
}
