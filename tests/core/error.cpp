// SPDX-License-Identifier: BSL-1.0
// Sentences: one form for all, one function that raises them, and the conditions that parameters are held to.

#include <ansatz/core/error.hpp>
#include <ansatz/units/requirements.hpp>

#include "tests/catch.hpp"
#include "tests/world/worlds.hpp"

#include <limits>
#include <type_traits>

using namespace ansatz;
using namespace ansatz::test;

TEST_CASE("a refusal is of its kind, and has the sentence that it was given", "[world][error]") {
    CHECK_THROWS_AS(refuse(Refusal::invalid_argument, "a sentence"), std::invalid_argument);
    CHECK_THROWS_AS(refuse(Refusal::out_of_range, "a sentence"), std::out_of_range);
    CHECK(sentence<std::out_of_range>([] { refuse(Refusal::out_of_range, "a sentence"); }) == "a sentence");
    CHECK(sentence<std::invalid_argument>([] { refuse_value("here", "this", "3 kg", "that"); }) ==
          "here: this is 3 kg; that");
    // The value itself, with its unit, or a number.
    CHECK(sentence<std::invalid_argument>([] { refuse_value("here", "this", 3.0 * kilogram, "that"); }) ==
          "here: this is 3 kg; that");
    CHECK(sentence<std::invalid_argument>([] { refuse_value("here", "this", metres(0, 1.5, 0), "that"); }) ==
          "here: this is (0, 1.5, 0) m; that");
    CHECK(sentence<std::invalid_argument>([] { refuse_value("here", "this", 3, "that"); }) == "here: this is 3; that");
}

TEST_CASE("parameters are held to be finite, not negative or positive, each with its own sentence",
          "[world][requirements]") {
    const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
    auto finite = [](double x) {
        return sentence<std::invalid_argument>([&] { require_finite("P", "p", x * second); });
    };
    auto not_negative = [](double x) {
        return sentence<std::invalid_argument>([&] { require_not_negative("P", "p", x * second); });
    };
    auto positive = [](double x) {
        return sentence<std::invalid_argument>([&] { require_positive("P", "p", x * second); });
    };
    for (const double x : {nan, inf, -inf}) {
        const auto begin = "P: p is " + describe(x * second) + "; it must be finite";
        CHECK(finite(x) == begin);
        CHECK(not_negative(x) == begin + " and not negative");
        CHECK(positive(x) == begin + " and greater than zero");
    }
    CHECK(finite(-1) == "nothing");
    CHECK(not_negative(-5e-324).find("P: p is ") == 0);
    CHECK(not_negative(0) == "nothing");
    CHECK(not_negative(-0.0) == "nothing");
    CHECK(positive(0) == "P: p is 0 s; it must be finite and greater than zero");
    CHECK(positive(5e-324) == "nothing");
    CHECK(sentence<std::invalid_argument>([&] { require_finite("P", "p", metres(0, nan, 0)); }) ==
          "P: p is (0, nan, 0) m; it must be finite");
}
