// SPDX-License-Identifier: BSL-1.0

// Hard case I1 in two dimensions; see global_order.hpp.

#include "tests/motion/global_order.hpp"

using namespace motion_tests;

TEST_CASE("I1 global order: 2-D double", "[motion][I1]") {
    for_each_type(AllIntegrators{}, []<class I> { GlobalOrder<2>::in_double<I>(); });
}

TEST_CASE("I1 global order: 2-D float", "[motion][I1]") {
    for_each_type(AllIntegrators{}, []<class I> { GlobalOrder<2>::in_float<I>(); });
}

TEST_CASE("I1 global order: 2-D float and double go the same way", "[motion][I1]") {
    for_each_type(AllIntegrators{}, []<class I> { GlobalOrder<2>::the_same_way<I>(); });
}
