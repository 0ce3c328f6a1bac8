// SPDX-License-Identifier: BSL-1.0
// The ground of MovingAI's maps: who may walk from where to where, by the rule that one takes.

#include "tests/paths/support.hpp"

#include <ansatz/paths/a_star.hpp>
#include <ansatz/paths/moving_ai.hpp>

#include <cmath>
#include <map>
#include <set>
#include <sstream>
#include <vector>

using namespace paths_tests;

namespace {

MovingAiMap map_of(const std::vector<std::string>& rows) {
    std::string text = "type octile\nheight " + std::to_string(rows.size()) + "\nwidth " +
                       std::to_string(rows.front().size()) + "\nmap\n";
    for (const auto& row : rows) text += row + "\n";
    std::istringstream in(text);
    return read_moving_ai_map(in, "by_hand.map");
}
/// The format's table, written out: from the letter of the row to the letters behind it.
bool by_table(char from, char to) {
    static const std::map<char, std::string> table{{'.', ".GS"}, {'G', ".GS"}, {'S', ".GSW"}, {'W', "SW"}};
    const auto row = table.find(from);
    return row != table.end() && row->second.find(to) != std::string::npos;
}

} // namespace

TEST_CASE("MovingAI's ground: land alone, or water and swamp by their kinds, on a map made by hand", "[paths]") {
    // A lake with a swamp on its shore, land on both sides, and a pond in the wood.
    const auto file = map_of({
        "..SWWWS..", //
        "..WWWWW..", //
        "TTTTTTTTT", //
        "..@WW@OGG",
    });
    const auto land = file.grid();
    const auto kinds = file.grid<Grid<>, GroundByKind>();
    AStar dry{land}, wet{kinds};
    const Cell west{0, 0}, east{8, 0}, water{3, 1};
    // Over land there is no way round the lake; through the swamp there is one, by water.
    CHECK(dry.find(west, east) == Outcome::no_path);
    REQUIRE(wet.find(west, east) == Outcome::found);
    CHECK(kinds.tiles(wet.path()) == 8); // in by the swamp at (2, 0), out by the one at (6, 0)
    CHECK(dry.find(west, water) == Outcome::blocked);
    REQUIRE(wet.find(west, water) == Outcome::found);
    // From land into water nobody steps, whichever way it lies: (1, 1) to (2, 1) leads by the swamp.
    REQUIRE(wet.find(Cell{1, 1}, Cell{2, 1}) == Outcome::found);
    CHECK(kinds.tiles(wet.path()) == 3); // (1, 0), (2, 0), (2, 1): no diagonal, for past it lies water
    CHECK(wet.find(Cell{3, 3}, Cell{4, 3}) == Outcome::found); // on the pond
    CHECK(wet.find(Cell{0, 3}, Cell{3, 3}) == Outcome::no_path);
    CHECK(wet.find(west, Cell{2, 3}) == Outcome::blocked); // out of bounds
    CHECK(wet.find(west, Cell{0, 2}) == Outcome::blocked); // a tree
    // A rule of one's own: a boat, on water alone.
    struct Boat {
        static bool passable(char tile) { return tile == 'W'; }
        static bool passable(char, char) { return true; } // between two such
    };
    const auto lake = file.grid<Grid<Four>, Boat>();
    AStar boat{lake};
    CHECK(boat.find(Cell{3, 0}, Cell{6, 1}) == Outcome::found);
    CHECK(boat.find(Cell{3, 0}, Cell{3, 3}) == Outcome::no_path);
    CHECK(lake.blocked_edges() == 0); // no byte for edges where no pair of kinds is separated
    CHECK(land.blocked_edges() == 0);
}

TEST_CASE("MovingAI's ground by its kinds: every step of random maps as the format's table", "[paths]") {
    std::mt19937 random(81);
    int parted = 0, passed = 0;
    for (int k = 0; k < 40; ++k) {
        std::vector<std::string> rows(7, std::string(8, '.'));
        for (auto& row : rows)
            for (char& tile : row) tile = ".GSWWS.T@O"[random() % 10];
        const auto file = map_of(rows);
        const auto eight = file.grid<Grid<>, GroundByKind>();
        const auto four = file.grid<Grid<Four>, GroundByKind>();
        const auto at = [&](int x, int y) {
            return x < 0 || y < 0 || x > 7 || y > 6 ? '@' : rows[std::size_t(y)][std::size_t(x)];
        };
        for (int y = 0; y < 7; ++y)
            for (int x = 0; x < 8; ++x) {
                const Cell from{std::uint16_t(x), std::uint16_t(y)};
                REQUIRE(eight.passable(from) == (std::set<char>{'.', 'G', 'S', 'W'}.count(at(x, y)) == 1));
                for (int dy = -1; dy <= 1; ++dy)
                    for (int dx = -1; dx <= 1; ++dx) {
                        if ((dx == 0 && dy == 0) || at(x + dx, y + dy) == '@') continue;
                        const Cell to{std::uint16_t(x + dx), std::uint16_t(y + dy)};
                        bool free = by_table(at(x, y), at(x + dx, y + dy));
                        if (dx != 0 && dy != 0) // the four straight steps round a diagonal
                            free = free && by_table(at(x, y), at(x + dx, y)) && by_table(at(x, y), at(x, y + dy)) &&
                                   by_table(at(x + dx, y), at(x + dx, y + dy)) &&
                                   by_table(at(x, y + dy), at(x + dx, y + dy));
                        REQUIRE(eight.passable(from, to) == free);
                        if (dx == 0 || dy == 0) REQUIRE(four.passable(from, to) == free);
                        passed += free;
                        parted += !free && eight.passable(from) && eight.passable(to);
                    }
            }
    }
    CHECK(parted > 500);
    CHECK(passed > 500);
}
