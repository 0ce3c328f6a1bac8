// SPDX-License-Identifier: BSL-1.0
// The best plans for several: what they cost is the least by a search over all places at once, and nobody meets
// anybody.

#include <ansatz/paths/conflict_based.hpp>

#include <ansatz/paths.hpp>

#include "tests/paths/crowds.hpp"

#include <array>
#include <functional>
#include <limits>
#include <queue>

using namespace paths_tests;
using namespace ansatz::test;

namespace {

constexpr auto none = std::numeric_limits<std::uint64_t>::max();

/// The least sum of costs, by Dijkstra's algorithm over the places of all, and who of them has come to stay.
template <class Map> std::uint64_t least_together(const Map& map, const std::vector<Errand>& errands) {
    const std::size_t n = map.size(), k = errands.size(), w = map.width();
    const auto cell = [&](std::size_t i) { return Cell{std::uint16_t(i % w), std::uint16_t(i / w)}; };
    std::size_t states = std::size_t(1) << k;
    for (std::size_t i = 0; i < k; ++i) states *= n;
    std::vector<std::uint64_t> costs(states, none);
    using Entry = std::pair<std::uint64_t, std::size_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    const auto number = [&](const std::vector<Cell>& at, unsigned stays) {
        std::size_t i = 0;
        for (const Cell c : at) i = i * n + map.index(c);
        return i << k | stays;
    };
    const auto relax = [&](const std::vector<Cell>& at, unsigned stays, std::uint64_t cost) {
        auto& known = costs[number(at, stays)];
        if (cost < known) known = cost, open.emplace(cost, number(at, stays));
    };
    std::vector<Cell> at, next(k);
    for (const auto& errand : errands) at.push_back(errand.start);
    relax(at, 0, 0);
    while (!open.empty()) {
        const auto [cost, state] = open.top();
        open.pop();
        if (cost > costs[state]) continue;
        const auto stays = unsigned(state & ((std::size_t(1) << k) - 1));
        if (stays == (1u << k) - 1) return cost;
        std::size_t rest = state >> k;
        for (std::size_t i = k; i-- > 0; rest /= n) at[i] = cell(rest % n);
        for (std::size_t i = 0; i < k; ++i) // one may decide to stay for good
            if (at[i] == errands[i].goal && (stays >> i & 1) == 0) relax(at, stays | 1u << i, cost);
        const std::function<void(std::size_t, std::uint64_t)> move = [&](std::size_t i, std::uint64_t sum) {
            if (i == k) return relax(next, stays, sum);
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx) {
                    const bool waits = dx == 0 && dy == 0;
                    if ((stays >> i & 1) != 0 && !waits) continue;
                    const Cell to{std::uint16_t(at[i].x + dx), std::uint16_t(at[i].y + dy)};
                    if (!waits && !map.passable(at[i], to)) continue;
                    next[i] = to;
                    Plans so_far;
                    for (std::size_t j = 0; j <= i; ++j) so_far.push_back({at[j], next[j]});
                    if (!collision(map, so_far).empty()) continue;
                    move(i + 1, sum + ((stays >> i & 1) != 0 ? 0 : cost_of({at[i], to})));
                }
        };
        move(0, cost);
    }
    return none;
}

} // namespace

TEMPLATE_TEST_CASE("what the plans cost together is the least there is", "[conflict_based]", Grid<>, Grid<Four>,
                   Grid<Eight<NoneFree>>) {
    std::mt19937 random(101);
    int compared = 0, without = 0, dearer_alone = 0, no_order = 0, given_up = 0;
    for (int i = 0; i < 260; ++i) {
        const bool three = i % 10 == 9;
        const auto high = 2 + random() % 3, wide = 3 + random() % 3; // one after the other: arguments have no order
        const auto map =
            three ? random_map<TestType>(random, 3, 3, 0.15) : random_map<TestType>(random, wide, high, 0.3);
        const auto errands = crowd(map, random, three ? 3 : 2);
        if (errands.size() < 2) continue;
        const auto best = least_together(map, errands);
        ConflictBased search{map};
        const auto outcome = search.find(errands, 300);
        INFO("crowd " << i);
        if (best == none) {
            CHECK(outcome != Outcome::found); // its tree may have no end
            CHECK(search.cost() == 0);
            CHECK(search.plan(0).empty());
            ++without;
            continue;
        }
        if (outcome != Outcome::found) { // the tree is large where somebody waits for long
            REQUIRE(outcome == Outcome::gave_up);
            ++given_up;
            continue;
        }
        const auto plans = [&] {
            Plans all;
            for (std::size_t k = 0; k < errands.size(); ++k) all.push_back(search.plan(k));
            return all;
        }();
        REQUIRE(collision(map, plans) == "");
        std::uint64_t sum = 0, alone = 0;
        for (std::size_t k = 0; k < errands.size(); ++k) {
            CHECK(plans[k].front() == errands[k].start);
            CHECK(plans[k].back() == errands[k].goal);
            sum += cost_of(plans[k]);
            AStar single{map};
            single.find(errands[k].start, errands[k].goal);
            alone += single.cost();
        }
        CHECK(sum == best);
        CHECK(search.cost() == best);
        CHECK(search.tiles() == Approx(double(best) / 33461));
        dearer_alone += alone < best;
        ++compared;
        Prioritised ranked{map};
        auto other = errands;
        std::reverse(other.begin(), other.end());
        const auto sum_of = [&](const std::vector<Errand>& order) {
            std::uint64_t all = 0;
            if (!ranked.find(order)) return none;
            for (std::size_t k = 0; k < order.size(); ++k) all += cost_of(ranked.plan(k));
            return all;
        };
        const auto ranks = std::min(sum_of(errands), sum_of(other));
        CHECK(ranks >= best);
        no_order += errands.size() == 2 && ranks == none;
    }
    CHECK(compared > 60);
    CHECK(without > 3);
    CHECK(dearer_alone > 10);
    CHECK(no_order > 0); // Prioritised finds none in either order
    CHECK(given_up * 20 < compared);
}

TEST_CASE("where no order has a plan there may be one, and it is found", "[conflict_based]") {
    const auto middle = grid_from<Grid<Four>>({"####.####", ".........", "#########"});
    const std::array<Errand, 2> errands{Errand{{0, 1}, {8, 1}}, Errand{{8, 1}, {0, 1}}};
    Prioritised ranked{middle};
    REQUIRE(!ranked.find(errands));
    REQUIRE(!ranked.find(std::array<Errand, 2>{errands[1], errands[0]}));
    ConflictBased search{middle};
    REQUIRE(search.find(errands) == Outcome::found);
    CHECK(collision(middle, {search.plan(0), search.plan(1)}) == "");
    CHECK(search.cost() == least_together(middle, {errands.begin(), errands.end()}));
    CHECK(search.tiles() == 19); // eight each, into the bay and out, and one step that the other waits
    CHECK(search.why() == "there is a plan for all 2 agents");
}

TEST_CASE("a corridor without a bay ends with the budget, and who has no path ends at once", "[conflict_based]") {
    const auto corridor = grid_from<Grid<Four>>({"......"});
    ConflictBased search{corridor};
    const std::array<Errand, 2> errands{Errand{{0, 0}, {5, 0}}, Errand{{5, 0}, {0, 0}}};
    CHECK(search.find(errands, 50) == Outcome::gave_up);
    CHECK(search.tree() == 50);
    CHECK(search.plan(1).empty());
    CHECK(search.steps() == 0);
    CHECK(search.why() == "after 50 nodes of the tree there was no plan without a meeting; there may be none");
    CHECK_THAT(refusal([&] { search.at(0, 1); }),
               ContainsSubstring("ConflictBased::at: the outcome is gave up; after 50 nodes"));
    const auto parted = grid_from<Grid<Four>>({"..#.."});
    ConflictBased apart{parted};
    CHECK(apart.find(std::array<Errand, 2>{Errand{{0, 0}, {1, 0}}, Errand{{1, 0}, {4, 0}}}) == Outcome::no_path);
    CHECK(apart.why() == "there is no plan for all 2 agents");
    CHECK(apart.tree() == 0);
    CHECK_THAT(refusal([&] { apart.find(std::span<const Errand>{}); }),
               ContainsSubstring("ConflictBased::find: the number of errands is 0; there must be one at least"));
    CHECK_THAT(refusal([&] {
                   apart.find(std::array<Errand, 1>{Errand{{0, 0}, {9, 0}}});
               }),
               ContainsSubstring("ConflictBased::find: a tile of agent 0 is (9, 0); the map has 5 x 1 tiles"));
    CHECK_THAT(refusal([&] { apart.plan(2); }), ContainsSubstring("ConflictBased::plan: agent is 2; the last search"));
}

TEST_CASE("what is forbidden is forbidden in its step and no other", "[conflict_based]") {
    Forbidden table;
    CHECK(table.last() == 0);
    CHECK(table.is_free({0, 0}, {1, 0}, 0));
    table.forbid(Cell{1, 0}, 3);
    table.forbid(Move{{1, 0}, {2, 0}}, 4);
    CHECK(table.last() == 5);
    CHECK(!table.is_free({0, 0}, {1, 0}, 2));
    CHECK(table.is_free({0, 0}, {1, 0}, 1));
    CHECK(table.is_free({0, 0}, {1, 0}, 3));
    CHECK(!table.is_free({1, 0}, {2, 0}, 4));
    CHECK(table.is_free({2, 0}, {1, 0}, 4));
    CHECK(table.is_free({1, 0}, {2, 0}, 5));
    CHECK(table.free_from({1, 0}) == 4);
    CHECK(table.free_from({2, 0}) == 0);
    table.clear();
    CHECK(table.is_free({0, 0}, {1, 0}, 2));
}
