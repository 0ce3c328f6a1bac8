// SPDX-License-Identifier: BSL-1.0
// How far bodies may come in a step, by hand.

#include "tests/collision/support.hpp"

#include <ansatz/collision/look_ahead.hpp>

using namespace collision_tests;

TEST_CASE("how far bodies come in a step, and which bodies meet", "[collision]") {
    using S = Space<double, 2>;
    Bodies bodies;
    const auto swap = [](std::size_t, std::size_t) {};
    for (const auto motion : {Motion::awake, Motion::awake, Motion::moving, Motion::fixed}) {
        bodies.push_back();
        bodies.move(Bodies::Slot(bodies.size() - 1), motion, swap);
    }
    LookAhead<S> ahead;
    const auto pull = [](Bodies::Slot) { return metres_per_second_squared(0, -10); };
    ahead.begin(bodies, 0.1 * second, pull, [](Bodies::Slot slot) {
        return slot == 2 ? metres_per_second(0, 2) : metres_per_second(3, 0); // two fly abreast, a platform rises
    });
    // 1.1 v dt, and a dt^2 of what is pulled
    CHECK_THAT(ahead.margin(bodies, 0, 3).value(), Catch::Matchers::WithinRel(0.33 + 0.1, 1e-12));
    CHECK_THAT(ahead.margin(bodies, 0, 1).value(), Catch::Matchers::WithinRel(2 * (0.33 + 0.1), 1e-12));
    CHECK_THAT(ahead.margin(bodies, 2, 3).value(), Catch::Matchers::WithinRel(0.22, 1e-12));
    CHECK(ahead.margin(bodies, 3, 3).value() == 0);
    CHECK(ahead.closes(bodies, 0, 3, 0.42));
    CHECK(!ahead.closes(bodies, 0, 3, 0.44));
    CHECK(ahead.closes(bodies, 0, 1, 0.19)); // abreast: only what pulls may bring them together
    CHECK(!ahead.closes(bodies, 0, 1, 0.21));
    auto lower = metres(-1, -1), upper = metres(1, 1);
    ahead.widen(bodies, 0, lower, upper); // by 1/256 of its width more: it may be pushed
    CHECK_THAT(upper.value()[0], Catch::Matchers::WithinRel(1 + 0.43 + 2.0 / 256, 1e-12));
    CHECK(lower.value()[1] == -upper.value()[1]);
    lower = metres(-1, -1), upper = metres(1, 1);
    ahead.widen(bodies, 3, lower, upper);
    CHECK((lower.value()[0] == -1 && upper.value()[0] == 1));
}
