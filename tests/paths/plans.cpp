// SPDX-License-Identifier: BSL-1.0
// Where plans meet, held against a simulator that does not know how they were made.

#include <ansatz/paths/plans.hpp>

#include "tests/paths/crowds.hpp"

#include <array>

using namespace paths_tests;

TEST_CASE("the first meeting is where a simulator finds the first", "[plans]") {
    std::mt19937 random(7);
    const Grid<> map(3, 3);
    int none = 0, kinds[3]{};
    for (int i = 0; i < 4000; ++i) {
        Plans plans(2 + random() % 2);
        for (auto& plan : plans) { // short random walks
            plan.push_back(random_cell(random, 3, 3));
            for (auto n = random() % 5; n > 0; --n) {
                const Cell to = random_cell(random, 3, 3);
                plan.push_back(map.passable(plan.back(), to) ? to : plan.back());
            }
        }
        const auto meeting = first_meeting(plans);
        const std::string found = collision(map, plans);
        INFO("plans " << i);
        REQUIRE(meeting.has_value() == !found.empty());
        none += !meeting;
        if (!meeting) continue;
        ++kinds[int(meeting->kind)];
        CHECK(found == std::array<std::string, 3>{"two in one tile", "two change places",
                                                  "two cross each other"}[std::size_t(meeting->kind)]);
        REQUIRE(meeting->first < meeting->second);
        REQUIRE(meeting->second < plans.size());
        CHECK(meeting->one ==
              Move{at(plans[meeting->first], meeting->step), at(plans[meeting->first], meeting->step + 1)});
        CHECK(meeting->other ==
              Move{at(plans[meeting->second], meeting->step), at(plans[meeting->second], meeting->step + 1)});
        CHECK(meet(meeting->one, meeting->other) == meeting->kind);
        // Nobody has met before it.
        Plans before = plans;
        for (auto& plan : before) plan.resize(std::min<std::size_t>(plan.size(), meeting->step));
        if (meeting->step > 0) CHECK(collision(map, before).empty());
    }
    CHECK(none > 300);
    for (const int kind : kinds) CHECK(kind > 30);
}
