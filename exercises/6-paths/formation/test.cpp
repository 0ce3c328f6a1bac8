// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on a squad and its formation (notes 6.3.2).

#include "tools/exercises/expect.hpp"

#include <algorithm>
#include <cstdlib>
#include <random>
#include <tuple>
#include <utility>

using namespace ansatz::workbook;
using exercise::Formation;
using exercise::Map;
using exercise::Offset;
using exercise::Slot;
using exercise::Tile;

namespace {

using Slots = std::vector<std::vector<Slot>>;

std::string said(Tile t) { return "(" + std::to_string(t.x) + ", " + std::to_string(t.y) + ")"; }
std::string said(Offset o) { return "(" + std::to_string(o.x) + ", " + std::to_string(o.y) + ")"; }
std::string said(const Slot& s) { return said(s.tile) + (s.blocked ? ", blocked" : ", not blocked"); }
std::string text_of(const std::vector<std::string>& rows) {
    std::string text;
    for (const auto& row : rows) text += "    " + row + '\n';
    return text;
}
void mark(std::vector<std::string>& rows, Tile t, char letter) {
    if (t.x >= 0 && t.y >= 0 && t.y < int(rows.size()) && t.x < int(rows[0].size()))
        rows[std::size_t(t.y)][std::size_t(t.x)] = letter;
}
void expect_size(const std::string& what, std::size_t yours, std::size_t right) {
    expect(yours == right, what + "\n    yours  " + std::to_string(yours) + "\n    right  " + std::to_string(right) +
                               "\nThere is one for each member.");
}

// Task 1

std::string drawn(const std::vector<Tile>& members) {
    int width = 0, height = 0;
    for (const Tile m : members) width = std::max(width, m.x + 1), height = std::max(height, m.y + 1);
    std::vector<std::string> rows(std::size_t(height), std::string(std::size_t(width), '.'));
    for (std::size_t i = 0; i < members.size(); ++i) mark(rows, members[i], char('0' + i));
    return "the members, by their number; places are (column, row)\n" + text_of(rows);
}
/// The tile from which the squares of the distances to all of them are the least: those of the mean are. Of two that
/// are equally good the one to the right, and below.
Tile right_centre(const std::vector<Tile>& members) {
    Tile best;
    long least = -1;
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x) {
            long squares = 0;
            for (const Tile m : members) squares += (m.x - x) * (m.x - x) + (m.y - y) * (m.y - y);
            if (least < 0 || squares <= least) least = squares, best = {x, y};
        }
    return best;
}
using Groups = std::vector<std::vector<Tile>>;
const Groups& groups() { // no mean of theirs is half-way between two tiles
    static const Groups all{{{5, 3}},
                            {{2, 3}, {1, 2}, {1, 4}, {0, 3}, {2, 5}},
                            {{9, 1}, {2, 2}, {3, 4}},
                            {{8, 0}, {7, 6}, {9, 5}, {7, 7}, {11, 6}},
                            {{0, 2}, {0, 3}, {6, 3}, {1, 9}, {1, 4}, {2, 5}, {1, 0}}};
    return all;
}
const Groups& half_way() {
    static const Groups all{{{4, 2}, {7, 2}}, {{3, 1}, {3, 4}}, {{6, 5}, {3, 2}, {5, 2}, {8, 1}}};
    return all;
}
void expect_centre(const std::vector<Tile>& members, const std::string& why) {
    const Tile yours = exercise::around_centre(members).centre, right = right_centre(members);
    double x = 0, y = 0;
    for (const Tile m : members) x += m.x / double(members.size()), y += m.y / double(members.size());
    expect(yours == right, drawn(members) + "the mean of the columns is " + detail::shown(x) + ", that of the rows " +
                               detail::shown(y) + "; the centre's tile\n    yours  " + said(yours) + "\n    right  " +
                               said(right) + "\n" + why);
}

// Task 2

const Map gap{{"..........#.........", "..........#.........", "....................", "..........#.........",
               "..........#.........", "..........#........."}};
const Map field{{".........", ".........", ".........", ".........", ".........", ".........", "........."}};
const Map room{{"......#.", ".#......", "....##..", ".#....#.", "........"}};
const std::vector<Offset> squad{{0, 0}, {-1, -1}, {-1, 1}, {-2, 0}, {0, 2}}, wedge{{0, 0}, {-1, -1}, {1, -1}, {3, 2}};

bool on_the_map(const Map& map, Tile t) {
    return t.x >= 0 && t.y >= 0 && t.y < int(map.rows.size()) && t.x < int(map.rows[0].size());
}
bool is_wall(const Map& map, int x, int y) { return map.rows[std::size_t(y)][std::size_t(x)] == '#'; }
/// Said anew: the line between the centres touches no wall's square, its sides and corners included. In halves of a
/// tile, so that all numbers are whole.
bool touches_no_wall(const Map& map, Tile from, Tile to) {
    for (int y = 0; y < int(map.rows.size()); ++y)
        for (int x = 0; x < int(map.rows[0].size()); ++x) {
            if (!is_wall(map, x, y)) continue;
            if (std::max(from.x, to.x) < x || std::min(from.x, to.x) > x) continue;
            if (std::max(from.y, to.y) < y || std::min(from.y, to.y) > y) continue;
            int left = 0, right = 0; // of the line, how many of the four corners
            for (const auto& [i, k] : {std::pair{-1, -1}, {1, -1}, {-1, 1}, {1, 1}}) {
                const int side = (to.x - from.x) * (2 * (y - from.y) + k) - (to.y - from.y) * (2 * (x - from.x) + i);
                left += side > 0, right += side < 0;
            }
            if (left < 4 && right < 4) return false;
        }
    return true;
}
Slot right_slot(const Map& map, Tile leader, Offset o) {
    const Tile own{leader.x + o.x, leader.y + o.y};
    return on_the_map(map, own) && touches_no_wall(map, leader, own) ? Slot{own, false} : Slot{leader, true};
}
std::string drawn(const Map& map, Tile leader, Tile own) {
    auto rows = map.rows;
    if (on_the_map(map, own) && !is_wall(map, own.x, own.y)) mark(rows, own, 'o');
    mark(rows, leader, 'L');
    return "L is the leader, o the place of the member, unless that is a wall or off the map; places are (column, "
           "row)\n" +
           text_of(rows);
}
/// One member of several.
void expect_slot(const Map& map, Tile leader, const std::vector<Offset>& offsets, std::size_t member,
                 const std::string& why) {
    const auto slots = exercise::slots_at(map, leader, offsets);
    expect_size("the leader is at " + said(leader) + "; slots of " + std::to_string(offsets.size()) + " members",
                slots.size(), offsets.size());
    const Offset o = offsets[member];
    const Slot yours = slots[member], right = right_slot(map, leader, o);
    expect(yours == right, drawn(map, leader, {leader.x + o.x, leader.y + o.y}) + "the leader is at " + said(leader) +
                               ", the offset of member " + std::to_string(member) + " is " + said(o) +
                               "; it should be at\n    yours  " + said(yours) + "\n    right  " + said(right) + "\n" +
                               why);
}

// Task 3

/// Where everybody is while the leader goes a way, by what is right in task 2.
Slots along(const Map& map, const std::vector<Offset>& offsets, const std::vector<Tile>& way) {
    Slots slots;
    for (const Tile leader : way) {
        slots.emplace_back();
        for (const Offset o : offsets) slots.back().push_back(right_slot(map, leader, o));
    }
    return slots;
}
/// How many steps to one of the eight neighbours lead from a tile to another: by rings around the first.
int steps_between(Tile from, Tile to) {
    std::vector<Tile> reached{from};
    int steps = 0;
    while (std::find(reached.begin(), reached.end(), to) == reached.end()) {
        std::vector<Tile> next;
        for (const Tile t : reached)
            for (int i = 0; i < 9; ++i) {
                const Tile n{t.x + i % 3 - 1, t.y + i / 3 - 1};
                const auto towards = [](int a, int b, int c) { return std::abs(c - b) <= std::abs(c - a); };
                if (towards(t.x, n.x, to.x) && towards(t.y, n.y, to.y) &&
                    std::find(next.begin(), next.end(), n) == next.end())
                    next.push_back(n);
            }
        reached = next, ++steps;
    }
    return steps;
}
std::vector<int> right_speeds(const Slots& slots) {
    std::vector<int> most(slots[0].size(), 0);
    for (std::size_t k = 1; k < slots.size(); ++k)
        for (std::size_t i = 0; i < most.size(); ++i)
            most[i] = std::max(most[i], steps_between(slots[k - 1][i].tile, slots[k][i].tile));
    return most;
}
/// On which tiles a member is while the leader walks.
std::string way_of(const Slots& slots, std::size_t member) {
    std::string tiles = "member " + std::to_string(member) + " is at, step by step of the leader, column and row,";
    for (std::size_t k = 0; k < slots.size(); ++k) tiles += (k % 10 ? " " : "\n    ") + said(slots[k][member].tile);
    return tiles + "\nthe most tiles that it goes in a step of the leader";
}
/// The speed of each member.
void expect_speeds(const Slots& slots, const std::vector<int>& right, const std::string& why) {
    const auto yours = exercise::catch_up_speeds(slots);
    expect_size("speeds of " + std::to_string(right.size()) + " members", yours.size(), right.size());
    for (std::size_t i = 0; i < right.size(); ++i) {
        expect(yours[i] == right[i], way_of(slots, i) + "\n    yours  " + std::to_string(yours[i]) + "\n    right  " +
                                         std::to_string(right[i]) + "\n" + why);
    }
}
const std::vector<Tile>& through_the_gap() {
    static const std::vector<Tile> way = [] {
        std::vector<Tile> tiles{{2, 3}};
        for (int x = 3; x <= 17; ++x) tiles.push_back({x, 2});
        return tiles;
    }();
    return way;
}
const std::vector<Tile>& over_the_field() {
    static const std::vector<Tile> way{{2, 2}, {3, 3}, {4, 3}, {5, 4}, {5, 3}, {4, 2}};
    return way;
}
Slots backwards(Slots slots) {
    std::reverse(slots.begin(), slots.end());
    return slots;
}
/// Members who are where they like, each step of theirs of any length.
Slots at_random(unsigned seed) {
    std::mt19937 random(seed);
    Slots slots(4, std::vector<Slot>(3));
    for (auto& step : slots)
        for (Slot& slot : step) slot = {{int(random() % 16), int(random() % 16)}, random() % 2 == 0};
    return slots;
}

} // namespace

TEST_CASE("the centre is the tile nearest to the mean", "[task-1][centre]") {
    for (const auto& members : groups())
        expect_centre(members, "What is right was found by trying all tiles: from the mean the squares of the "
                               "distances to all members add up to the least.");
}

TEST_CASE("half a tile counts to the right, and down", "[task-1][half]") {
    for (const auto& members : half_way())
        expect_centre(members,
                      "Half-way between two tiles it is the one with the larger number, of columns as of rows.");
}

TEST_CASE("everybody stands where it stood", "[task-1][stands]") {
    for (const Groups& some : {groups(), half_way()})
        for (const auto& members : some) {
            const Formation f = exercise::around_centre(members);
            expect_size(drawn(members) + "offsets", f.offsets.size(), members.size());
            for (std::size_t i = 0; i < members.size(); ++i) {
                const Offset right{members[i].x - f.centre.x, members[i].y - f.centre.y};
                expect(f.offsets[i] == right,
                       drawn(members) + "your centre is at " + said(f.centre) + "; the offset of member " +
                           std::to_string(i) + ", who is at " + said(members[i]) + "\n    yours  " +
                           said(f.offsets[i]) + "\n    right  " + said(right) +
                           "\nThe centre's tile and its offset together must be the tile on which it stands.");
            }
        }
}

TEST_CASE("somewhere else it is the same formation", "[task-1][elsewhere]") {
    for (const auto& members : groups()) {
        auto shifted = members;
        for (Tile& m : shifted) m.x += 11, m.y += 6;
        const Formation here = exercise::around_centre(members), there = exercise::around_centre(shifted);
        expect_size(drawn(members) + "offsets", here.offsets.size(), members.size());
        expect_size(drawn(shifted) + "offsets", there.offsets.size(), members.size());
        for (std::size_t i = 0; i < members.size(); ++i)
            expect(here.offsets[i] == there.offsets[i],
                   drawn(members) + "the offset of member " + std::to_string(i) +
                       "\n    yours, here                    " + said(here.offsets[i]) +
                       "\n    yours, all shifted by (11, 6)  " + said(there.offsets[i]) +
                       "\nWho stands beside whom does not depend on where they are.");
    }
}

TEST_CASE("in the open everybody has its place", "[task-2][own-place]") {
    for (std::size_t i = 0; i < squad.size(); ++i)
        expect_slot(field, {4, 3}, squad, i,
                    "No wall is near. Its place is the leader's tile and its offset together.");
    for (std::size_t i = 0; i < wedge.size(); ++i)
        expect_slot(field, {2, 4}, wedge, i,
                    "No wall is near. Its place is the leader's tile and its offset together.");
}

TEST_CASE("nobody is put into a wall", "[task-2][wall]") {
    expect_slot(gap, {10, 2}, squad, 4, "Its place is a wall: it closes up to the leader, and is told.");
    expect_slot(gap, {11, 2}, squad, 1, "Its place is a wall: it closes up to the leader, and is told.");
}

TEST_CASE("nor behind one", "[task-2][behind]") {
    expect_slot(gap, {11, 4}, squad, 3,
                "Its place is free, and a wall is between it and the leader. A search for the leader says nothing of "
                "how one comes there.");
    expect_slot(gap, {10, 2}, squad, 2, "Its place is free, but the line to the leader touches the corner of a wall.");
}

TEST_CASE("nor off the map", "[task-2][outside]") {
    const std::string why = "There is no such tile. It closes up to the leader, and is told.";
    expect_slot(field, {0, 3}, squad, 3, why);
    expect_slot(field, {4, 0}, squad, 1, why);
    expect_slot(field, {4, 6}, squad, 4, why);
    expect_slot(field, {7, 2}, wedge, 3, why);
}

TEST_CASE("the leader is on its own tile", "[task-2][leader]") {
    for (const Tile leader : {Tile{10, 2}, Tile{0, 0}, Tile{11, 2}})
        expect_slot(gap, leader, squad, 0,
                    "With no offset it has a place of its own everywhere, in the narrowest gap as well.");
}

TEST_CASE("everywhere in a room, at every offset", "[task-2][everywhere]") {
    std::vector<Offset> offsets;
    for (int y = -4; y <= 4; ++y)
        for (int x = -5; x <= 5; ++x) offsets.push_back({x, y});
    for (int y = 0; y < int(room.rows.size()); ++y)
        for (int x = 0; x < int(room.rows[0].size()); ++x) {
            if (is_wall(room, x, y)) continue;
            for (std::size_t i = 0; i < offsets.size(); ++i)
                expect_slot(room, {x, y}, {offsets[i]}, 0,
                            "What is right was found by holding the line from centre to centre against the square of "
                            "each wall, its corners included.");
        }
}

TEST_CASE("in the open all are as fast as the leader", "[task-3][in-the-open]") {
    for (const auto& offsets : {squad, std::vector<Offset>{{0, 0}, {-2, -2}, {3, 1}}})
        expect_speeds(along(field, offsets, over_the_field()), std::vector<int>(offsets.size(), 1),
                      "In formation all walk the same way, only elsewhere: a tile a step, past a corner too.");
}

TEST_CASE("who stands goes nowhere", "[task-3][stands-still]") {
    expect_speeds(along(field, squad, {{4, 3}}), {0, 0, 0, 0, 0}, "The leader has gone no tile, and nobody else has.");
    expect_speeds(along(field, wedge, {{2, 4}, {2, 4}, {2, 4}}), {0, 0, 0, 0}, "Everybody waits.");
}

TEST_CASE("who closes up must run", "[task-3][closes-up]") {
    const Slots slots = along(gap, squad, through_the_gap());
    const Slots up(slots.begin() + 6, slots.begin() + 10); // to the leader in the gap
    expect_speeds(
        up, {1, 2, 2, 1, 2},
        "Who is blocked goes from its own place to the leader's tile in one step of the leader, which is a tile "
        "ahead by then. All others go a tile a step.");
}

TEST_CASE("and who falls in again as well", "[task-3][falls-in]") {
    const Slots slots = along(gap, squad, through_the_gap());
    const Slots out(slots.begin() + 8, slots.begin() + 14); // from the leader in the gap
    expect_speeds(
        out, right_speeds(out),
        "Who was blocked goes from the leader's tile to its own place in one step of the leader. All others go "
        "a tile a step.");
}

TEST_CASE("backwards they are as fast", "[task-3][backwards]") {
    const Slots slots = along(gap, squad, through_the_gap()), back = backwards(slots);
    const auto there = exercise::catch_up_speeds(slots), again = exercise::catch_up_speeds(back);
    expect_size("speeds of 5 members", there.size(), 5);
    expect_size("speeds of 5 members", again.size(), 5);
    for (std::size_t i = 0; i < 5; ++i)
        expect(there[i] == again[i],
               way_of(slots, i) + "\n    yours, this way           " + std::to_string(there[i]) +
                   "\n    yours, from end to start  " + std::to_string(again[i]) +
                   "\n    right                     the same\nThe same steps are walked the other way round.");
}

TEST_CASE("each step of each member counts", "[task-3][each-step]") {
    for (unsigned seed = 1; seed <= 8; ++seed) {
        const Slots slots = at_random(seed);
        expect_speeds(slots, right_speeds(slots),
                      "What is right was found by going from neighbour to neighbour, step by step.");
    }
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    if (task == 1)
        for (const Groups& some : {groups(), half_way()})
            for (const auto& members : some) {
                const Formation f = exercise::around_centre(members);
                numbers.push_back(2 + f.centre.x), numbers.push_back(2 + f.centre.y);
                for (const Offset o : f.offsets) numbers.push_back(40 + o.x), numbers.push_back(40 + o.y);
            }
    if (task == 2)
        for (const auto& [map, leader, offsets] :
             std::vector<std::tuple<Map, Tile, std::vector<Offset>>>{{field, {4, 3}, squad},
                                                                     {field, {2, 4}, wedge},
                                                                     {gap, {10, 2}, squad},
                                                                     {gap, {11, 2}, squad},
                                                                     {gap, {11, 4}, squad},
                                                                     {field, {0, 3}, squad},
                                                                     {field, {4, 0}, squad},
                                                                     {field, {4, 6}, squad},
                                                                     {field, {7, 2}, wedge},
                                                                     {room, {3, 2}, wedge},
                                                                     {room, {5, 3}, wedge}}) {
            for (const Slot& s : exercise::slots_at(map, leader, offsets))
                for (const int n : {s.tile.x, s.tile.y, s.blocked ? 1 : 0}) numbers.push_back(9 + n);
            numbers.push_back(1);
        }
    if (task == 3) {
        Slots few = along(gap, squad, through_the_gap());
        for (const Slots& slots : {few, backwards(few), along(field, squad, over_the_field()),
                                   along(field, squad, {{4, 3}}), at_random(1), at_random(2)}) {
            for (const int speed : exercise::catch_up_speeds(slots)) numbers.push_back(1 + speed);
            numbers.push_back(-1);
        }
    }
    return numbers;
}
