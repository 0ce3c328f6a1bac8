// SPDX-License-Identifier: BSL-1.0
// What a test says that it measured is within its bound or not: the ends belong to it, and what is no number is in no
// bound.

#include "tests/measured.hpp"
#include "tests/catch.hpp"

#include <cmath>
#include <limits>
#include <tuple>

using namespace ansatz::test;

TEST_CASE("a measure is held by its bound, ends included, and no number by none", "[tools]") {
    const double infinite = std::numeric_limits<double>::infinity();
    for (const auto& [value, bound, held] : {std::tuple(1.0, at_most(1), true),
                                             {std::nextafter(1.0, 2.0), at_most(1), false},
                                             {-5.0, at_most(1), true},
                                             {2.0, at_least(2), true},
                                             {std::nextafter(2.0, 1.0), at_least(2), false},
                                             {1e300, at_least(2), true},
                                             {1.0, between(1, 2), true},
                                             {2.0, between(1, 2), true},
                                             {0.5, between(1, 2), false},
                                             {2.5, between(1, 2), false},
                                             {9.5, about(10, 0.5), true},
                                             {10.75, about(10, 0.5), false},
                                             {infinite, at_most(1), false},
                                             {-infinite, at_least(1), false},
                                             {std::nan(""), at_most(1), false},
                                             {std::nan(""), at_least(1), false},
                                             {std::nan(""), between(1, 2), false}}) {
        CAPTURE(value, bound.lowest, bound.highest);
        CHECK(measured("X0", "a number of this test", value, bound, "m") == held);
    }
}
