// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on two agents at once (notes 6.3.4).

#include "tools/exercises/expect.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <tuple>

using namespace ansatz::workbook;
using exercise::Both;
using exercise::Place;
using exercise::Room;

namespace {

/// The corridor of section 6.3.4 with its bay, and a room with a pillar.
const Room corridor{"####.####", ".........", "#########"};
const Room small{"....", ".#..", "...."};
const Room wide{"........", "........", "........", "........", "........"};

using Key = std::array<int, 4>;
Key key(const Both& p) { return {p.a.y, p.a.x, p.b.y, p.b.x}; }
std::string said(Place p) { return "(" + std::to_string(p.x) + ", " + std::to_string(p.y) + ")"; }
std::string said(const Both& p) { return "A " + said(p.a) + ", B " + said(p.b); }
bool free(const Room& room, Place p) {
    return p.y >= 0 && p.x >= 0 && p.y < int(room.size()) && p.x < int(room[0].size()) &&
           room[std::size_t(p.y)][std::size_t(p.x)] == '.';
}
std::string drawn(Room room, const Both& now) {
    room[std::size_t(now.a.y)][std::size_t(now.a.x)] = 'A', room[std::size_t(now.b.y)][std::size_t(now.b.x)] = 'B';
    std::string text;
    for (const auto& row : room) text += "    " + row + '\n';
    return text;
}
/// In an order of their own, and without the one in which both wait.
std::vector<Both> sorted(std::vector<Both> pairs, const Both& now) {
    std::erase(pairs, now);
    std::sort(pairs.begin(), pairs.end(), [](const Both& p, const Both& q) { return key(p) < key(q); });
    return pairs;
}
/// Said anew: all pairs of tiles are tried, and two meet if they are in one point at the end of the step or half-way.
std::vector<Both> right_pairs(const Room& room, const Both& now) {
    const auto near = [](Place p, Place q) { return std::abs(p.x - q.x) + std::abs(p.y - q.y) <= 1; };
    const auto twice_half_way = [](Place p, Place q) { return Place{p.x + q.x, p.y + q.y}; };
    std::vector<Both> pairs;
    for (int i = 0; i < 25; ++i)
        for (int k = 0; k < 25; ++k) {
            const Place a{now.a.x + i % 5 - 2, now.a.y + i / 5 - 2}, b{now.b.x + k % 5 - 2, now.b.y + k / 5 - 2};
            if (free(room, a) && free(room, b) && near(a, now.a) && near(b, now.b) && !(a == b) &&
                !(twice_half_way(a, now.a) == twice_half_way(b, now.b)))
                pairs.push_back({a, b});
        }
    return sorted(pairs, now);
}
/// Of all pairs in which two can be.
std::vector<Both> all_pairs(const Room& room) {
    std::vector<Place> places;
    for (int y = 0; y < int(room.size()); ++y)
        for (int x = 0; x < int(room[0].size()); ++x)
            if (free(room, {x, y})) places.push_back({x, y});
    std::vector<Both> pairs;
    for (const Place a : places)
        for (const Place b : places)
            if (!(a == b)) pairs.push_back({a, b});
    return pairs;
}
void expect_pair(const Room& room, const Both& now, const Both& next, bool right, const std::string& why) {
    const auto pairs = exercise::next_pairs(room, now);
    const bool yours = std::count(pairs.begin(), pairs.end(), next) > 0;
    const auto word = [](bool possible) { return possible ? "possible" : "not possible"; };
    expect(yours == right, drawn(room, now) + "from " + said(now) + "\nto   " + said(next) + "\n    yours  " +
                               word(yours) + "\n    right  " + word(right) + "\n" + why);
}
/// The first pair that one list has and the other has not.
std::string difference(const std::vector<Both>& yours, const std::vector<Both>& right) {
    for (const Both& p : right)
        if (std::count(yours.begin(), yours.end(), p) == 0) return said(p) + " is missing in yours";
    for (const Both& p : yours)
        if (std::count(right.begin(), right.end(), p) == 0) return said(p) + " is in yours and not possible";
    return "yours has a pair twice";
}

/// How many steps it is to some goals from each pair, breadth first over the edges that are given; without those from
/// which there is no plan.
template <class Edges> std::map<Key, int> steps_from(const Both& start, const Edges& edges) {
    std::map<Key, int> steps{{key(start), 0}};
    std::vector<Both> list{start};
    for (std::size_t i = 0; i < list.size(); ++i)
        for (const Both& next : edges(list[i]))
            if (steps.try_emplace(key(next), steps[key(list[i])] + 1).second) list.push_back(next);
    return steps;
}

struct Asked {
    Both now, goals;
};
const std::vector<Asked>& errands() {
    static const std::vector<Asked> all{{{{0, 0}, {7, 4}}, {{5, 2}, {4, 4}}},  // 7 and 3
                                        {{{1, 1}, {6, 3}}, {{2, 1}, {0, 1}}},  // 1 and 8
                                        {{{3, 4}, {0, 2}}, {{3, 0}, {2, 2}}},  // 4 and 2
                                        {{{7, 0}, {2, 3}}, {{3, 3}, {4, 0}}}}; // 7 and 5
    return all;
}
void expect_estimate(const Room& room, const Asked& q, int right, const std::string& why) {
    const int yours = exercise::estimate(q.now, q.goals);
    expect(yours == right, drawn(room, q.now) + "A wants to " + said(q.goals.a) + ", B to " + said(q.goals.b) +
                               "; steps, estimated\n    yours  " + std::to_string(yours) + "\n    right  " +
                               std::to_string(right) + "\n" + why);
}

} // namespace

TEST_CASE("far from each other both step as they like", "[task-1][far]") {
    const Both now{{2, 2}, {6, 2}};
    expect_pair(wide, now, {{3, 2}, {6, 1}}, true, "Both walk in the same step.");
    expect_pair(wide, now, {{2, 1}, {5, 2}}, true, "Both walk in the same step.");
    const auto yours = sorted(exercise::next_pairs(wide, now), now);
    expect(yours.size() == 24, drawn(wide, now) + "pairs, without the one in which both wait\n    yours  " +
                                   std::to_string(yours.size()) +
                                   "\n    right  24\nEach has five ways to spend a step, the four tiles beside and to "
                                   "wait; together they have 5 x 5.");
}

TEST_CASE("one may wait while the other walks", "[task-1][wait]") {
    const Both now{{3, 1}, {5, 1}};
    expect_pair(corridor, now, {{3, 1}, {4, 1}}, true, "A waits. Without that nobody ever lets another pass.");
    expect_pair(corridor, now, {{4, 1}, {5, 1}}, true, "B waits. Without that nobody ever lets another pass.");
}

TEST_CASE("nobody walks into a wall or out of the room", "[task-1][walls]") {
    const Both now{{0, 1}, {8, 1}};
    expect_pair(corridor, now, {{0, 0}, {8, 1}}, false, "A would be in a wall.");
    expect_pair(corridor, now, {{1, 1}, {8, 2}}, false, "B would be in a wall.");
    expect_pair(corridor, now, {{1, 1}, {9, 1}}, false, "B would be outside of the room.");
    expect_pair(corridor, now, {{-1, 1}, {7, 1}}, false, "A would be outside of the room.");
}

TEST_CASE("two are never in one tile", "[task-1][one-tile]") {
    expect_pair(corridor, {{3, 1}, {5, 1}}, {{4, 1}, {4, 1}}, false, "Both come to it.");
    expect_pair(corridor, {{3, 1}, {4, 1}}, {{4, 1}, {4, 1}}, false, "B waits there.");
    expect_pair(corridor, {{4, 0}, {4, 1}}, {{4, 0}, {4, 0}}, false, "A waits in the bay.");
}

TEST_CASE("two cannot change places", "[task-1][swap]") {
    expect_pair(corridor, {{3, 1}, {4, 1}}, {{4, 1}, {3, 1}}, false,
                "In no step they are in one tile, but half-way they would meet.");
    expect_pair(corridor, {{4, 1}, {4, 0}}, {{4, 0}, {4, 1}}, false,
                "In no step they are in one tile, but half-way they would meet.");
}

TEST_CASE("one may follow the other", "[task-1][follow]") {
    expect_pair(corridor, {{3, 1}, {4, 1}}, {{4, 1}, {5, 1}}, true, "B is gone when A comes.");
    expect_pair(corridor, {{4, 1}, {5, 1}}, {{4, 0}, {4, 1}}, true,
                "A steps into the bay, and B comes to where it was.");
}

TEST_CASE("from every pair to every possible one", "[task-1][all]") {
    for (const Room& room : {small, corridor})
        for (const Both& now : all_pairs(room)) {
            const auto yours = sorted(exercise::next_pairs(room, now), now), right = right_pairs(room, now);
            expect(yours == right, drawn(room, now) + "from " + said(now) + "\n    " + difference(yours, right) +
                                       "\nWhat is right was found by trying all tiles: two meet if they are in one "
                                       "point at the end of the step or half-way.");
        }
}

TEST_CASE("over these edges the two pass each other in ten steps", "[task-1][corridor]") {
    const Both start{{0, 1}, {8, 1}}, goals{{8, 1}, {0, 1}};
    const auto steps = steps_from(start, [](const Both& p) {
        auto next = exercise::next_pairs(corridor, p);
        std::erase_if(next, [](const Both& q) { return !free(corridor, q.a) || !free(corridor, q.b); });
        return next;
    });
    const auto found = steps.find(key(goals));
    expect(found != steps.end() && found->second == 10,
           drawn(corridor, start) + "steps until each is where the other was\n    yours  " +
               (found == steps.end() ? std::string("there is no plan") : std::to_string(found->second)) +
               "\n    right  10\nEight for each alone. One of them steps into the bay, waits and comes out again: two "
               "more.");
}

TEST_CASE("both are there when the later one is", "[task-2][later]") {
    for (const Asked& q : errands()) {
        const auto steps = [](Place p, Place to) { return std::abs(p.x - to.x) + std::abs(p.y - to.y); };
        const int a = steps(q.now.a, q.goals.a), b = steps(q.now.b, q.goals.b);
        expect_estimate(wide, q, std::max(a, b),
                        "A alone needs " + std::to_string(a) + " steps, B alone " + std::to_string(b) +
                            ". They walk at the same time, column by column and row by row.");
    }
}

TEST_CASE("at the goals nothing is left", "[task-2][goals]") {
    for (const Asked& q : errands())
        expect_estimate(wide, {q.goals, q.goals}, 0, "Both are there. Where they are from each other does not matter.");
}

TEST_CASE("it is never too much", "[task-2][never-too-much]") {
    for (const Room& room : {small, corridor}) {
        const auto all = all_pairs(room);
        for (const Both& goals : {all.front(), all[all.size() / 2], all.back()}) {
            const auto steps = steps_from(goals, [&](const Both& p) { return right_pairs(room, p); }); // as many back
            for (const Both& now : all) {
                const auto found = steps.find(key(now));
                if (found == steps.end()) continue;
                const int yours = exercise::estimate(now, goals);
                expect(yours <= found->second,
                       drawn(room, now) + "A wants to " + said(goals.a) + ", B to " + said(goals.b) +
                           "; steps, estimated\n    yours  " + std::to_string(yours) + "\n    right  " +
                           std::to_string(found->second) +
                           " or less\nSo many it are, by the best plan for both. With an estimate "
                           "that is more, A* may miss it.");
            }
        }
    }
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    if (task == 1)
        for (const auto& [room, now] : std::vector<std::pair<Room, Both>>{{wide, {{2, 2}, {6, 2}}},
                                                                          {corridor, {{3, 1}, {4, 1}}},
                                                                          {corridor, {{4, 1}, {5, 1}}},
                                                                          {corridor, {{0, 1}, {8, 1}}},
                                                                          {small, {{1, 0}, {0, 1}}},
                                                                          {small, {{3, 2}, {2, 2}}}}) {
            for (const Both& p : sorted(exercise::next_pairs(room, now), now))
                for (const int n : key(p)) numbers.push_back(2 + n);
            numbers.push_back(-1);
        }
    if (task == 2)
        for (const Asked& q : errands()) {
            numbers.push_back(exercise::estimate(q.now, q.goals));
            numbers.push_back(exercise::estimate(q.goals, q.goals));
        }
    return numbers;
}
