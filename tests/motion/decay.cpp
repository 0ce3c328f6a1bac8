// SPDX-License-Identifier: BSL-1.0

// decay(x) = e^-x from IEEE operations only, so that no library's exp decides about the last bit (hard case I20).

#include "tests/catch.hpp"

#include <ansatz/motion/decay.hpp>
#include <ansatz/units.hpp>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <cmath>
#include <limits>

using ansatz::decay;

TEST_CASE("decay is within an ulp of e^-x from 0 to where doubles end", "[motion][decay]") {
    using Wide = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<30>, boost::multiprecision::et_off>;
    double worst = 0, at = 0;
    auto look = [&](double x) {
        const double exact = static_cast<double>(exp(Wide(-x)));
        const double ulp = std::nextafter(exact, 2.0) - exact;
        const double off = std::abs(static_cast<double>((Wide(decay(x)) - exp(Wide(-x))) / Wide(ulp)));
        if (off > worst) {
            worst = off;
            at = x;
        }
    };
    for (double x = 1e-20; x < 1; x *= 1.37) look(x);
    for (double x = 0; x < 708; x += 0.3713) look(x);
    for (int k = 1; k < 1000; ++k) { // where the reduction changes its k
        const double edge = (k + 0.5) * std::log(2.0);
        if (edge < 708) look(std::nextafter(edge, 0)), look(edge), look(std::nextafter(edge, 1e3));
    }
    INFO("worst " << worst << " ulp at x = " << at);
    CHECK(worst <= 1.5); // half an ulp is the rounding of a perfect one
}

TEST_CASE("decay is exactly 1 at 0, 0 far out, never above 1, never rising, and keeps NaN", "[motion][decay]") {
    CHECK(decay(0.0) == 1.0);
    CHECK(decay(0.0f) == 1.0f);
    CHECK(decay(1e6) == 0.0);
    CHECK(decay(std::numeric_limits<double>::infinity()) == 0.0);
    CHECK(std::isnan(decay(std::numeric_limits<double>::quiet_NaN())));
    CHECK(decay(std::numeric_limits<double>::min()) == 1.0);
    CHECK(decay(745.0) > 0.0); // the smallest doubles
    double before = 1;
    bool falls = true;
    for (double x = 0; x < 800; x += 0.0137) {
        const double now = decay(x);
        falls = falls && now <= before && now >= 0;
        before = now;
    }
    CHECK(falls);
}

TEST_CASE("decay in float is the double's, rounded once", "[motion][decay]") {
    for (float x = 1e-6f; x < 100; x *= 1.01f) REQUIRE(decay(x) == static_cast<float>(decay(double(x))));
}

TEST_CASE("decay of a rate times a time is that of the number", "[motion][decay]") {
    using namespace ansatz;
    const auto of_doubles = 3.0 / second * (0.1 * second);
    STATIC_REQUIRE(std::is_same_v<decltype(decay(of_doubles)), double>);
    CHECK(decay(of_doubles) == decay(of_doubles.value())); // to the bit: not by the exp of the standard library
    CHECK(decay<double>(of_doubles) == decay(of_doubles.value()));
    CHECK(decay(scalar_cast<float>(of_doubles)) == decay(scalar_cast<float>(of_doubles).value()));

    using Wide = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<30>, boost::multiprecision::et_off>;
    const auto of_wide = scalar_cast<Wide>(of_doubles);
    CHECK(decay(of_wide) == exp(Wide(-of_wide.value())));
}
