// SPDX-License-Identifier: BSL-1.0
// Plans for many, one after the other: no collision by an independent simulator in a thousand crowds, each plan the
// cheapest around those before it by brute force, and the failures that the order brings.

#include <ansatz/paths/prioritised.hpp>
#include <ansatz/paths/reservations.hpp>

#include <ansatz/paths.hpp>

#include "tests/paths/crowds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <vector>

using namespace paths_tests;
using namespace ansatz::test;

namespace {

/// The least cost from start to goal around the plans of others, by testing every tile in every step.
template <class Map> std::uint64_t least(const Map& map, const Plans& others, const Errand& errand, std::size_t steps) {
    constexpr auto none = std::numeric_limits<std::uint64_t>::max();
    const std::size_t n = map.size(), w = map.width();
    std::vector<std::uint64_t> now(n, none), next;
    now[map.index(errand.start)] = 0;
    std::uint64_t best = none;
    std::size_t last = 0; // from when on nobody else comes to the goal
    for (const auto& plan : others)
        for (std::size_t s = 0; s < plan.size() + 1; ++s)
            if (at(plan, s) == errand.goal) last = std::max(last, s + 1 < plan.size() ? s + 1 : steps + 1);
    for (std::size_t s = 0; s <= steps; ++s) {
        if (s >= last) best = std::min(best, now[map.index(errand.goal)]);
        next.assign(n, none);
        for (std::size_t i = 0; i < n; ++i) {
            if (now[i] == none) continue;
            const Cell from{std::uint16_t(i % w), std::uint16_t(i / w)};
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx) {
                    const Cell to{std::uint16_t(from.x + dx), std::uint16_t(from.y + dy)};
                    if (!(from == to) && !map.passable(from, to)) continue;
                    auto all = others;
                    for (auto& plan : all) plan = {at(plan, s), at(plan, s + 1)};
                    all.push_back({from, to});
                    if (!collision(map, all).empty()) continue;
                    auto& cost = next[map.index(to)];
                    cost = std::min(cost, now[i] + cost_of({from, to}));
                }
        }
        std::swap(now, next);
    }
    return best;
}
} // namespace

TEMPLATE_TEST_CASE("in a thousand crowds nobody meets anybody", "[prioritised]", Grid<>, Grid<Four>) {
    std::mt19937 random(83);
    int all_planned = 0, failed = 0, waited = 0;
    for (int i = 0; i < 500; ++i) {
        const auto map = random_map<TestType>(random, 6 + random() % 10, 6 + random() % 10, 0.2);
        const auto errands = crowd(map, random, 2 + random() % 10);
        if (errands.empty()) continue;
        Prioritised search{map};
        const bool found = search.find(errands);
        const std::size_t n = found ? errands.size() : search.failed();
        const auto plans = plans_of(search, n);
        INFO("crowd " << i);
        REQUIRE(collision(map, plans) == "");
        for (std::size_t k = 0; k < n; ++k) {
            CHECK(plans[k].front() == errands[k].start);
            CHECK(plans[k].back() == errands[k].goal);
            CHECK(plans[k].size() <= search.steps() + 1);
            for (std::size_t s = 1; s < plans[k].size(); ++s) waited += plans[k][s] == plans[k][s - 1];
        }
        if (n > 0) {
            AStar alone{map};
            REQUIRE(alone.find(errands[0].start, errands[0].goal) == Outcome::found);
            CHECK(cost_of(plans[0]) == alone.cost()); // the first makes way for nobody
        }
        if (!found) CHECK(search.plan(n).empty());
        ++(found ? all_planned : failed);
    }
    CHECK(all_planned > 100);
    CHECK(failed > 20);
    CHECK(waited > 50);
}

TEST_CASE("each plan is the cheapest around those before it, or there is none", "[prioritised]") {
    std::mt19937 random(89);
    int compared = 0, none = 0;
    for (int i = 0; i < 120; ++i) {
        const auto map = random_map(random, 5, 4, 0.2);
        const auto errands = crowd(map, random, 4);
        if (errands.size() < 2) continue;
        Prioritised search{map};
        const bool found = search.find(errands);
        const std::size_t n = found ? errands.size() : search.failed() + 1;
        for (std::size_t k = 0; k < n; ++k) {
            const auto before = plans_of(search, k);
            const auto best = least(map, before, errands[k], search.steps() + map.size() + 1);
            INFO("crowd " << i << " agent " << k);
            const bool fails = k == search.failed();
            CHECK(best == (fails ? std::numeric_limits<std::uint64_t>::max() : cost_of(search.plan(k))));
            ++(fails ? none : compared);
        }
    }
    CHECK(compared > 150);
    CHECK(none > 5);
}

TEST_CASE("the order decides, and there are crowds for which no order has a plan", "[prioritised]") {
    const auto map = grid_from<Grid<Four>>({"######.##", ".........", "#########"});
    const std::array<Errand, 2> one{Errand{{0, 1}, {8, 1}}, Errand{{8, 1}, {0, 1}}}, other{one[1], one[0]};
    Prioritised search{map};
    CHECK(search.find(one)); // the bay is near the second, who waits in it
    CHECK(collision(map, plans_of(search, 2)) == "");
    CHECK(std::count(search.plan(1).begin(), search.plan(1).end(), Cell{6, 0}) > 0);
    CHECK(search.why() == "there is a plan for all 2 agents");
    CHECK(!search.find(other));
    CHECK(search.failed() == 1);
    CHECK(search.why() == "there is no plan for agent 1 around those of the 1 before it; another order may have one");

    // In the middle nobody is there in time, though one of them could wait for the other before the bay.
    const auto middle = grid_from<Grid<Four>>({"####.####", ".........", "#########"});
    Prioritised both{middle};
    CHECK(!both.find(one));
    CHECK(!both.find(other));
    const Plans together{{{0, 1}, {0, 1}, {1, 1}, {2, 1}, {3, 1}, {4, 1}, {5, 1}, {6, 1}, {7, 1}, {8, 1}},
                         {{8, 1}, {7, 1}, {6, 1}, {5, 1}, {4, 1}, {4, 0}, {4, 1}, {3, 1}, {2, 1}, {1, 1}, {0, 1}}};
    CHECK(collision(middle, together) == "");

    const auto corridor = grid_from<Grid<Four>>({"........."});
    Prioritised narrow{corridor};
    CHECK(!narrow.find(std::array<Errand, 2>{Errand{{0, 0}, {8, 0}}, Errand{{8, 0}, {0, 0}}}));
}

TEST_CASE("who waits for a goal to be free for good does so", "[prioritised]") {
    const auto map = grid_from<Grid<Four>>({".....", "##.##"});
    // The first walks through the goal of the second, who must not stand there too early.
    const std::array<Errand, 2> errands{Errand{{0, 0}, {4, 0}}, Errand{{2, 1}, {2, 0}}};
    Prioritised search{map};
    REQUIRE(search.find(errands));
    CHECK(collision(map, plans_of(search, 2)) == "");
    CHECK(search.at(1, 2) == Cell{2, 1});
    CHECK(search.at(1, 3) == Cell{2, 0});
    CHECK(search.at(1, 99) == Cell{2, 0});
}

TEST_CASE("what cannot be planned or reserved is refused in a sentence", "[prioritised]") {
    const Grid<> map(6, 6);
    Prioritised search{map};
    using Errands = std::vector<Errand>;
    CHECK_THAT(refusal([&] { search.find(Errands{}); }), ContainsSubstring("the number of errands is 0"));
    CHECK_THAT(refusal([&] {
                   search.find(Errands{{{0, 0}, {7, 1}}});
               }),
               ContainsSubstring("a tile of agent 0 is (7, 1); the map has 6 x 6 tiles"));
    CHECK_THAT(refusal([&] {
                   search.find(Errands{{{0, 0}, {1, 1}}, {{0, 0}, {2, 2}}});
               }),
               ContainsSubstring("the start of agents 0 and 1 is one tile; each needs its own"));
    CHECK_THAT(refusal([&] {
                   search.find(Errands{{{0, 0}, {1, 1}}, {{2, 0}, {1, 1}}});
               }),
               ContainsSubstring("the goal of agents 0 and 1 is one tile"));
    CHECK_THAT(refusal([&] { search.plan(0); }), ContainsSubstring("Prioritised::plan: agent is 0; the last search"));
    const auto corridor = grid_from<Grid<Four>>({"......"});
    Prioritised narrow{corridor};
    REQUIRE(!narrow.find(Errands{{{0, 0}, {5, 0}}, {{5, 0}, {0, 0}}}));
    CHECK(narrow.at(0, 5) == Cell{5, 0});
    CHECK(narrow.plan(1).empty());
    CHECK_THAT(refusal([&] { narrow.at(1, 0); }),
               ContainsSubstring("Prioritised::at: agent is 1; it must be one that has a plan; there is no plan for"));
    CHECK_THAT(refusal([&] { narrow.at(2, 0); }), ContainsSubstring("agent is 2; the last search had 2 agents"));

    Reservations table;
    table.take(0, std::vector<Cell>{{0, 0}, {1, 0}, {2, 0}});
    const auto taken = [&](std::vector<Cell> plan) { return refusal([&] { table.take(1, plan); }); };
    CHECK_THAT(taken({{0, 1}, {1, 0}}), ContainsSubstring("the tile (1, 0) in step 1 is reserved for agent 0; a plan"));
    CHECK_THAT(taken({{1, 0}, {0, 0}}), ContainsSubstring("the tile (0, 0) in step 1 is on the way of another"));
    CHECK_THAT(taken({{0, 0}}), ContainsSubstring("the tile (0, 0) in step 0 is reserved for agent 0"));
    CHECK_THAT(taken({{5, 5}, {4, 4}, {3, 3}, {2, 2}, {2, 1}, {2, 0}}),
               ContainsSubstring("the tile (2, 0) in step 5 is reserved for agent 0"));
    CHECK_THAT(taken({}), ContainsSubstring("the plan is empty"));
    CHECK(table.owner({5, 5}, 0) == Reservations::nobody);
    CHECK(table.owner({2, 0}, 1) == Reservations::nobody);
    CHECK(table.owner({2, 0}, 2) == 0);
    CHECK(table.owner({2, 0}, 1000) == 0);
    table.take(1, std::vector<Cell>{{1, 0}, {2, 1}}); // leaves before the other comes
    CHECK(table.last() == 2);
    table.clear();
    CHECK(table.owner({2, 0}, 2) == Reservations::nobody);
}
