// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on a line of sight (notes 6.3.9).

#include "tools/exercises/expect.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

using namespace ansatz::workbook;
using exercise::Room;
using exercise::Tile;

namespace {

std::string said(Tile t) { return "(" + std::to_string(t.x) + ", " + std::to_string(t.y) + ")"; }
std::string said(const std::vector<Tile>& tiles) {
    std::string text;
    for (const Tile t : tiles) text += (text.empty() ? "" : " ") + said(t);
    return text.empty() ? "none" : text;
}
bool wall(const Room& room, Tile t) { return room[std::size_t(t.y)][std::size_t(t.x)] == '#'; }
std::string drawn(const Room& room, Tile from, Tile to) {
    auto rows = room;
    if (!wall(room, to)) rows[std::size_t(to.y)][std::size_t(to.x)] = 'B';
    if (!wall(room, from)) rows[std::size_t(from.y)][std::size_t(from.x)] = 'A';
    std::string text;
    for (const auto& row : rows) text += "    " + row + '\n';
    return text;
}

/// How a straight line lies to the square of a tile, without a walk along it. Two convex shapes are apart if they are
/// in the direction of x, of y, or at a right angle to the line. In halves of a tile every number is whole.
enum class Lie { apart, touching, inside };
Lie lie(Tile from, Tile to, Tile t) {
    if (from == to) return t == from ? Lie::inside : Lie::apart;
    const int dx = to.x - from.x, dy = to.y - from.y;
    const int across = std::abs(2 * (dx * (t.y - from.y) - dy * (t.x - from.x))) - (std::abs(dx) + std::abs(dy));
    const int left = 2 * std::min(from.x, to.x) - (2 * t.x + 1), right = 2 * t.x - 1 - 2 * std::max(from.x, to.x);
    const int above = 2 * std::min(from.y, to.y) - (2 * t.y + 1), below = 2 * t.y - 1 - 2 * std::max(from.y, to.y);
    const int most = std::max({across, left, right, above, below});
    return most < 0 ? Lie::inside : most == 0 ? Lie::touching : Lie::apart;
}

struct Ends {
    Tile from, to;
};
int length(const Ends& e) { return std::abs(e.to.x - e.from.x) + std::abs(e.to.y - e.from.y); }
/// The shortest first, so that what fails is as small as it can be.
std::vector<Ends> sorted(std::vector<Ends> all) {
    std::stable_sort(all.begin(), all.end(), [](const Ends& a, const Ends& b) { return length(a) < length(b); });
    return all;
}
std::vector<Tile> tiles_within(int columns, int rows) {
    std::vector<Tile> tiles;
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x) tiles.push_back({x, y});
    return tiles;
}
/// Of 19 x 17 tiles: from the middle to each, and from a corner and from the side.
const std::vector<Tile>& all_tiles() {
    static const std::vector<Tile> all = tiles_within(19, 17);
    return all;
}
const std::vector<Ends>& all_lines() {
    static const std::vector<Ends> all = [] {
        std::vector<Ends> ends;
        for (const Tile from : {Tile{9, 8}, {0, 0}, {18, 3}})
            for (const Tile to : all_tiles()) ends.push_back({from, to});
        return sorted(ends);
    }();
    return all;
}
bool along_a_row(const Ends& e) { return e.from.x == e.to.x || e.from.y == e.to.y; }
bool through_a_corner(const Ends& e) {
    return std::any_of(all_tiles().begin(), all_tiles().end(),
                       [&](Tile t) { return lie(e.from, e.to, t) == Lie::touching; });
}
std::vector<Tile> right_line(const Ends& e) {
    std::vector<Tile> tiles;
    for (const Tile t : all_tiles())
        if (lie(e.from, e.to, t) == Lie::inside) tiles.push_back(t);
    // In the order in which they lie along the line.
    const auto along = [&](Tile t) {
        return (e.to.x - e.from.x) * (t.x - e.from.x) + (e.to.y - e.from.y) * (t.y - e.from.y);
    };
    std::sort(tiles.begin(), tiles.end(), [&](Tile a, Tile b) { return along(a) < along(b); });
    return tiles;
}
template <class Which> void expect_lines(const Which& which, const std::string& why) {
    for (const Ends& e : all_lines()) {
        const auto yours = exercise::line(e.from, e.to);
        if (!which(e)) continue;
        const auto right = right_line(e);
        expect(yours == right, "the tiles of the line from " + said(e.from) + " to " + said(e.to) + "\n    yours  " +
                                   said(yours) + "\n    right  " + said(right) + "\n" + why);
    }
}

const Room bare{".......", ".......", ".......", ".......", "......."};
const Room pillar{".......", ".......", "...#...", ".......", "......."};
const Room gap{"...#...", "..#....", ".......", "....#..", "...#..."};

/// Those, and rooms with walls at random, from a few to many.
const std::vector<Room>& rooms() {
    static const std::vector<Room> all = [] {
        std::vector<Room> made{bare, pillar, gap};
        std::uint32_t seed = 11;
        for (const unsigned walls : {5u, 12u, 20u, 35u}) {
            Room room(7, std::string(9, '.'));
            for (auto& row : room)
                for (char& tile : row)
                    if (((seed = seed * 1664525u + 1013904223u) >> 8) % 100 < walls) tile = '#';
            made.push_back(room);
        }
        return made;
    }();
    return all;
}
std::vector<Ends> pairs(const Room& room) {
    const auto tiles = tiles_within(int(room[0].size()), int(room.size()));
    std::vector<Ends> all;
    for (const Tile from : tiles)
        for (const Tile to : tiles) all.push_back({from, to});
    return sorted(all);
}
/// The line may not even touch the square of a wall.
bool right_sight(const Room& room, const Ends& e) {
    const auto tiles = tiles_within(int(room[0].size()), int(room.size()));
    return std::none_of(tiles.begin(), tiles.end(),
                        [&](Tile t) { return wall(room, t) && lie(e.from, e.to, t) != Lie::apart; });
}
std::string word(bool seen) { return seen ? "seen" : "not seen"; }
void expect_sight(const Room& room, Tile from, Tile to, bool right, const std::string& why) {
    const bool yours = exercise::sees(room, from, to);
    expect(yours == right, "B at " + said(to) + " from A at " + said(from) + "\n" + drawn(room, from, to) +
                               "    yours  " + word(yours) + "\n    right  " + word(right) + "\n" + why);
}

} // namespace

TEST_CASE("along a row or a column the line enters every tile between", "[task-1][row]") {
    expect_lines(along_a_row, "One after the other, from the first tile to the last, both included.");
}

TEST_CASE("every tile counts that the line enters, however little of it", "[task-1][entered]") {
    expect_lines([](const Ends& e) { return !along_a_row(e) && !through_a_corner(e); },
                 "The right ones were found by asking each tile whether the line passes through its square.");
}

TEST_CASE("exactly through a corner the line steps diagonally", "[task-1][corner]") {
    expect_lines(
        [](const Ends& e) { return !along_a_row(e) && through_a_corner(e); },
        "Where the line goes through the point at which four tiles meet, it leaves one of them and enters the one "
        "opposite.");
}

TEST_CASE("there and back the line enters the same tiles", "[task-1][back]") {
    for (const Ends& e : all_lines()) {
        const auto there = exercise::line(e.from, e.to);
        auto back = exercise::line(e.to, e.from);
        std::reverse(back.begin(), back.end());
        expect(there == back, "the line between " + said(e.from) + " and " + said(e.to) +
                                  "\n    yours, there          " + said(there) + "\n    yours, back, reversed " +
                                  said(back) + "\nIt is one line, at whichever end it begins.");
    }
}

TEST_CASE("in an empty room everything is seen", "[task-2][open]") {
    for (const Ends& e : pairs(bare))
        expect_sight(bare, e.from, e.to, true, "Nothing is in between. A tile is seen from itself, too.");
}

TEST_CASE("nothing is seen through a wall", "[task-2][wall]") {
    for (const int y : {1, 3, 0, 4})
        expect_sight(pillar, {3, y}, {3, 4 - y}, false, "The line goes through the middle of the pillar.");
    expect_sight(pillar, {0, 2}, {6, 2}, false, "The line goes through the middle of the pillar.");
    expect_sight(pillar, {0, 1}, {6, 2}, false, "The line goes through the pillar.");
    expect_sight(pillar, {0, 0}, {6, 3}, false, "The line cuts off a corner of the pillar.");
    expect_sight(pillar, {6, 1}, {0, 4}, false, "The line cuts off a corner of the pillar.");
    expect_sight(pillar, {0, 1}, {6, 1}, true, "The line passes the pillar.");
}

TEST_CASE("a wall does not see, and is not seen", "[task-2][ends]") {
    for (const Tile t : {Tile{2, 2}, {3, 1}, {6, 4}, {0, 0}}) {
        expect_sight(pillar, t, {3, 2}, false, "B is the wall: nobody can walk into it.");
        expect_sight(pillar, {3, 2}, t, false, "A is the wall: nobody stands there.");
    }
    expect_sight(pillar, {3, 2}, {3, 2}, false, "Both are the wall: nobody stands there.");
}

TEST_CASE("no line squeezes past a corner", "[task-2][squeeze]") {
    const std::string one = "One of the two tiles beside a diagonal step of the line is a wall.";
    expect_sight(gap, {2, 0}, {3, 1}, false, "Both tiles beside this diagonal step are walls.");
    expect_sight(gap, {4, 4}, {3, 3}, false, "Both tiles beside this diagonal step are walls.");
    expect_sight(gap, {1, 1}, {2, 2}, false, one);
    expect_sight(gap, {3, 1}, {5, 3}, false, one);
    for (const Tile t : {Tile{3, 1}, {3, 3}}) {
        expect_sight(pillar, {2, 2}, t, false, one);
        expect_sight(pillar, t, {4, 2}, false, one);
    }
    expect_sight(pillar, {1, 2}, {4, 3}, false, "The line goes exactly through a corner of the pillar.");
    expect_sight(gap, {4, 1}, {6, 3}, true, "No wall lies beside a step of this line.");
}

TEST_CASE("a tile is seen if no wall so much as touches the line", "[task-2][all]") {
    for (const Room& room : rooms())
        for (const Ends& e : pairs(room))
            expect_sight(room, e.from, e.to, right_sight(room, e),
                         "The right answer was found by asking each wall whether the line touches its square.");
}

TEST_CASE("what sees a tile is seen from it", "[task-2][both-ways]") {
    for (const Room& room : rooms())
        for (const Ends& e : pairs(room)) {
            const bool there = exercise::sees(room, e.from, e.to), back = exercise::sees(room, e.to, e.from);
            expect(there == back, "A at " + said(e.from) + " and B at " + said(e.to) + "\n" +
                                      drawn(room, e.from, e.to) + "    B from A, yours  " + word(there) +
                                      "\n    A from B, yours  " + word(back) +
                                      "\nIt is one line, at whichever end it begins.");
        }
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    if (task == 1)
        for (const Tile to : all_tiles()) {
            for (const Tile t : exercise::line({9, 8}, to)) numbers.insert(numbers.end(), {2.0 + t.x, 3.0 + t.y});
            numbers.push_back(1);
        }
    if (task == 2)
        for (const Room& room : rooms())
            for (const Ends& e : pairs(room))
                if (length(e) < 6) numbers.push_back(exercise::sees(room, e.from, e.to) ? 2 : 1);
    return numbers;
}
