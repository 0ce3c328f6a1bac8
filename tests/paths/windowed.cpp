// SPDX-License-Identifier: BSL-1.0
// Crowds that plan a window ahead: nobody ever meets anybody, by a simulator of its own; who is alone walks the
// cheapest path; goals and maps that change on the way.

#include <ansatz/paths/windowed.hpp>

#include <ansatz/paths.hpp>

#include "tests/paths/crowds.hpp"

#include <array>

using namespace paths_tests;
using namespace ansatz::test;

namespace {

/// Has a crowd walk and writes down where everybody was.
template <class Map> Plans walk(Windowed<Map>& crowd, std::size_t steps, std::size_t patience = 60) {
    Plans walked(crowd.size());
    const auto note = [&] {
        for (std::size_t i = 0; i < crowd.size(); ++i) walked[i].push_back(crowd.at(i));
    };
    note();
    for (std::size_t s = 0; s < steps && !crowd.all_arrived() && crowd.stalled() < patience; ++s) {
        crowd.step();
        note();
    }
    return walked;
}

} // namespace

TEMPLATE_TEST_CASE("in a thousand crowds that plan a window ahead nobody meets anybody", "[windowed]", Grid<>,
                   Grid<Four>) {
    std::mt19937 random(131);
    int all_there = 0, left_over = 0, where_ranks_fail = 0, reachable = 0;
    for (int i = 0; i < 500; ++i) {
        const auto map = random_map<TestType>(random, 6 + random() % 10, 6 + random() % 10, 0.2);
        auto errands = crowd(map, random, 2 + random() % 10);
        if (errands.empty()) continue;
        bool possible = true;
        for (const auto& errand : errands) {
            AStar alone{map};
            possible = possible && alone.find(errand.start, errand.goal) == Outcome::found;
        }
        Windowed team{map, 2 + unsigned(random() % 20)};
        team.begin(errands);
        const auto walked = walk(team, 400);
        INFO("crowd " << i);
        REQUIRE(collision(map, walked) == "");
        for (std::size_t k = 0; k < errands.size(); ++k) {
            CHECK(walked[k].front() == errands[k].start);
            CHECK(team.arrived(k) == (team.at(k) == errands[k].goal));
        }
        if (!possible) {
            CHECK(!team.all_arrived());
            continue;
        }
        ++reachable;
        ++(team.all_arrived() ? all_there : left_over);
        Prioritised ranked{map};
        if (team.all_arrived() && !ranked.find(errands)) ++where_ranks_fail;
    }
    CAPTURE(all_there, left_over, where_ranks_fail, reachable);
    CHECK(all_there > 10 * left_over);
    CHECK(where_ranks_fail > 5); // Prioritised, in the order of the list
}

TEST_CASE("who is alone walks the cheapest path whatever the window", "[windowed]") {
    std::mt19937 random(137);
    int compared = 0;
    for (int i = 0; i < 200; ++i) {
        const auto map = random_map(random, 12, 9, 0.3);
        const auto errands = crowd(map, random, 1);
        AStar alone{map};
        if (errands.empty() || alone.find(errands[0].start, errands[0].goal) != Outcome::found) continue;
        Windowed one{map, 2 + unsigned(random() % 30)};
        one.begin(errands);
        const auto walked = walk(one, 1000);
        CHECK(one.all_arrived());
        CHECK(cost_of(walked[0]) == alone.cost());
        CHECK(walked[0].size() == alone.path().size()); // and does not wait
        ++compared;
    }
    CHECK(compared > 100);
}

TEST_CASE("a corridor without a bay stalls, and one with a bay does not", "[windowed]") {
    const std::array<Errand, 2> errands{Errand{{0, 1}, {8, 1}}, Errand{{8, 1}, {0, 1}}};
    const auto narrow = grid_from<Grid<Four>>({"#########", ".........", "#########"});
    Windowed stuck{narrow, 8};
    stuck.begin(errands);
    auto walked = walk(stuck, 300);
    CHECK(collision(narrow, walked) == "");
    CHECK(!stuck.all_arrived());
    CHECK(stuck.stalled() == 60);
    const auto bay = grid_from<Grid<Four>>({"######.##", ".........", "#########"});
    Windowed team{bay, 16};
    team.begin(errands);
    walked = walk(team, 300);
    CHECK(collision(bay, walked) == "");
    CHECK(team.all_arrived());
    ConflictBased best{bay};
    REQUIRE(best.find(errands) == Outcome::found);
    CHECK(cost_of(walked[0]) + cost_of(walked[1]) >= best.cost());
    // In the middle it is where no order has a plan: to wait before it for the other's sake nobody thinks of.
    const auto middle = grid_from<Grid<Four>>({"####.####", ".........", "#########"});
    Windowed both{middle, 16};
    both.begin(errands);
    walked = walk(both, 300);
    CHECK(collision(middle, walked) == "");
    CHECK(both.stalled() == 60);
}

TEST_CASE("who stands at its goal makes way and comes back", "[windowed]") {
    const auto map = grid_from<Grid<Four>>({".....", "##.##"});
    Windowed team{map, 10};
    team.begin(std::array<Errand, 2>{Errand{{2, 0}, {2, 0}}, Errand{{0, 0}, {4, 0}}});
    CHECK(team.arrived(0));
    bool away = false;
    for (int s = 0; s < 30 && !team.all_arrived(); ++s) {
        team.step();
        away = away || !team.arrived(0);
        CHECK(!(team.at(0) == team.at(1)));
    }
    CHECK(away);
    CHECK(team.all_arrived());
}

TEST_CASE("goals and walls that change on the way are heeded from the next step on", "[windowed]") {
    std::mt19937 random(139);
    std::size_t reached = 0;
    for (int i = 0; i < 60; ++i) {
        auto map = random_map(random, 14, 14, 0.1);
        const auto errands = crowd(map, random, 6);
        Windowed team{map, 12};
        team.begin(errands);
        Plans walked(errands.size());
        for (int s = 0; s < 150; ++s) {
            for (std::size_t k = 0; k < team.size(); ++k) walked[k].push_back(team.at(k));
            for (std::size_t k = 0; k < team.size(); ++k) {
                if (!team.arrived(k)) continue;
                ++reached;
                const Cell next = random_cell(random, 14, 14);
                bool taken = !map.passable(next);
                for (std::size_t other = 0; other < team.size(); ++other)
                    taken = taken || (other != k && team.goal(other) == next);
                if (!taken) team.set_goal(k, next);
            }
            const Cell wall = random_cell(random, 14, 14);
            bool stands = false;
            for (std::size_t k = 0; k < team.size(); ++k) stands = stands || team.at(k) == wall;
            if (!stands && s % 5 == 0) map.set_passable(wall, random() % 3 != 0);
            Plans before(team.size());
            for (std::size_t k = 0; k < team.size(); ++k) before[k] = {team.at(k)};
            team.step();
            for (std::size_t k = 0; k < team.size(); ++k) before[k].push_back(team.at(k));
            REQUIRE(collision(map, before) == ""); // on the map as it is now
        }
    }
    CHECK(reached > 1500);
    // A copy goes on alike.
    const Grid<> open(9, 9);
    Windowed team{open};
    team.begin(crowd(open, random, 12));
    team.step();
    auto copy = team;
    for (int s = 0; s < 30; ++s) team.step(), copy.step();
    for (std::size_t k = 0; k < team.size(); ++k) CHECK(team.at(k) == copy.at(k));
    CHECK(team.expanded() == copy.expanded());
}

TEST_CASE("what a crowd cannot do it says, and goes on as before", "[windowed]") {
    const auto map = grid_from<Grid<>>({"....", ".#.."});
    CHECK_THAT(refusal([&] {
                   Windowed{map, 1};
               }),
               ContainsSubstring("Windowed: the window is 1; it must be from 2 to 10000 steps"));
    Windowed team{map};
    team.step();
    CHECK(team.all_arrived());
    CHECK_THAT(refusal([&] { team.begin(std::span<const Errand>{}); }),
               ContainsSubstring("Windowed::begin: the number of errands is 0"));
    CHECK_THAT(refusal([&] {
                   team.begin(std::array<Errand, 1>{Errand{{1, 1}, {0, 0}}});
               }),
               ContainsSubstring("the start of agent 0 is (1, 1); it must be passable"));
    team.begin(std::array<Errand, 2>{Errand{{0, 0}, {3, 0}}, Errand{{3, 1}, {0, 1}}});
    CHECK_THAT(refusal([&] {
                   team.set_goal(0, {0, 1});
               }),
               ContainsSubstring("Windowed::set_goal: the goal is (0, 1); it is that of agent 1; each needs its own"));
    CHECK_THAT(refusal([&] { team.set_goal(0, {9, 1}); }), ContainsSubstring("the map has 4 x 2 tiles"));
    CHECK_THAT(refusal([&] { team.at(2); }),
               ContainsSubstring("Windowed::at: agent is 2; there are 2, counted from 0"));
    CHECK(team.goal(0) == Cell{3, 0});
    const auto parted = grid_from<Grid<>>({"..#.", "..#."});
    Windowed apart{parted};
    apart.begin(std::array<Errand, 1>{Errand{{0, 0}, {3, 0}}});
    for (int s = 0; s < 20; ++s) apart.step();
    CHECK(apart.at(0) == Cell{0, 0}); // whose goal is out of reach stays
    CHECK(apart.stalled() == 20);
}
