// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on flags (notes 6.3.1).

#include "tools/exercises/expect.hpp"

using namespace ansatz::workbook;
using exercise::Map;
using exercise::Step;
using exercise::Tile;

namespace {

std::string said(Tile t) { return "(" + std::to_string(t.x) + ", " + std::to_string(t.y) + ")"; }
std::string drawn(const Map& map, Tile from, Tile to) {
    auto rows = map.rows;
    auto mark = [&](Tile t, char letter) {
        if (map.contains(t) && !map.wall(t)) rows[std::size_t(t.y)][std::size_t(t.x)] = letter;
    };
    mark(to, 'B'), mark(from, 'A');
    std::string text;
    for (const auto& row : rows) text += "    " + row + '\n';
    return text;
}

/// Steps of one map, and whether each is possible.
struct Asked {
    Map map;
    Tile from, to;
    bool right;
};
const Map open{{"....", "....", "...."}, {}}, walls{{"....", ".#..", "...."}, {}}, pair{{"..", ".#"}, {}},
    other_pair{{"#.", ".."}, {}}, touching{{".#", "#."}, {}};

const std::vector<Asked>& on_open_ground() {
    static const std::vector<Asked> all = [] {
        std::vector<Asked> asked;
        for (int y = 0; y < 3; ++y)
            for (int x = 0; x < 3; ++x)
                if (x != 1 || y != 1) asked.push_back({open, {1, 1}, {x, y}, true});
        return asked;
    }();
    return all;
}
const std::vector<Asked>& too_far() {
    static const std::vector<Asked> all = {{open, {1, 1}, {1, 1}, false},
                                           {open, {0, 1}, {2, 1}, false},
                                           {open, {1, 0}, {1, 2}, false},
                                           {open, {0, 0}, {2, 2}, false},
                                           {open, {3, 0}, {1, 1}, false}};
    return all;
}
const std::vector<Asked>& off_the_map() {
    static const std::vector<Asked> all = {{open, {0, 0}, {-1, 0}, false}, {open, {0, 0}, {0, -1}, false},
                                           {open, {3, 1}, {4, 1}, false},  {open, {1, 2}, {1, 3}, false},
                                           {open, {3, 2}, {4, 3}, false},  {open, {-1, 0}, {0, 0}, false}};
    return all;
}
const std::vector<Asked>& into_walls() {
    static const std::vector<Asked> all = {{walls, {0, 1}, {1, 1}, false},
                                           {walls, {1, 0}, {1, 1}, false},
                                           {walls, {1, 1}, {2, 1}, false},
                                           {walls, {1, 1}, {1, 2}, false},
                                           {walls, {2, 1}, {3, 1}, true}};
    return all;
}
const std::vector<Asked>& past_corners() {
    static const std::vector<Asked> all = {{walls, {0, 1}, {1, 0}, false},    {walls, {1, 2}, {2, 1}, false},
                                           {pair, {0, 1}, {1, 0}, false},     {other_pair, {0, 1}, {1, 0}, false},
                                           {touching, {0, 0}, {1, 1}, false}, {touching, {1, 1}, {0, 0}, false},
                                           {walls, {2, 0}, {3, 1}, true}};
    return all;
}
void expect_steps(const std::vector<Asked>& all, const std::string& why) {
    for (const auto& a : all) {
        const bool yours = exercise::may_step(a.map, a.from, a.to);
        expect(yours == a.right, "from A at " + said(a.from) + " to B at " + said(a.to) + "\n" +
                                     drawn(a.map, a.from, a.to) + "    yours  " +
                                     (yours ? "possible" : "not possible") + "\n    right  " +
                                     (a.right ? "possible" : "not possible") + "\n" + why);
    }
}

/// A tile, and where steps lead from it.
struct Around {
    Map map;
    Tile from;
};
const std::vector<Around>& without_shut() {
    static const std::vector<Around> all = {{open, {1, 1}},  {open, {0, 0}},  {open, {3, 2}},
                                            {walls, {0, 0}}, {walls, {2, 2}}, {walls, {1, 1}}};
    return all;
}
const std::vector<Around>& with_shut() {
    static const Map drop{{"....", "....", "...."}, {{{1, 1}, {1, 0}}, {{1, 1}, {2, 2}}, {{0, 0}, {1, 0}}}};
    static const std::vector<Around> all = {
        {drop, {1, 1}}, {drop, {1, 0}}, {drop, {2, 2}}, {drop, {0, 0}}, {drop, {0, 1}}};
    return all;
}
/// Sorted by row and column.
std::vector<Tile> sorted(std::vector<Tile> tiles) {
    std::sort(tiles.begin(), tiles.end(), [](Tile a, Tile b) { return a.y != b.y ? a.y < b.y : a.x < b.x; });
    return tiles;
}
/// What is right, from a table of what a step needs: written anew, so that task 1 cannot spoil the test of task 2.
std::vector<Tile> right_neighbours(const Around& a) {
    std::vector<Tile> all;
    auto free = [&](int x, int y) { return a.map.contains({x, y}) && !a.map.wall({x, y}); };
    for (int y = a.from.y - 1; y <= a.from.y + 1; ++y)
        for (int x = a.from.x - 1; x <= a.from.x + 1; ++x) {
            bool possible = !(Tile{x, y} == a.from) && free(a.from.x, a.from.y) && free(x, y) && free(a.from.x, y) &&
                            free(x, a.from.y);
            for (const Step& s : a.map.shut)
                if (s.from == a.from && s.to == Tile{x, y}) possible = false;
            if (possible) all.push_back({x, y});
        }
    return all;
}
void expect_neighbours(const std::vector<Around>& all, const std::string& why) {
    for (const auto& a : all) {
        const auto yours = sorted(exercise::neighbours(a.map, a.from)), right = right_neighbours(a);
        auto list = [](const std::vector<Tile>& tiles) {
            std::string text;
            for (const Tile t : tiles) text += " " + said(t);
            return text.empty() ? std::string(" none") : text;
        };
        std::string shut;
        for (const Step& s : a.map.shut) shut += " " + said(s.from) + " to " + said(s.to);
        expect(yours == right, "steps from A at " + said(a.from) + (shut.empty() ? "" : ", shut are" + shut) + "\n" +
                                   drawn(a.map, a.from, a.from) + "    yours " + list(yours) + "\n    right " +
                                   list(right) + "\n" + why);
    }
}

} // namespace

TEST_CASE("on open ground each of the eight neighbours is a step away", "[task-1][eight]") {
    expect_steps(on_open_ground(), "Four neighbours share a side, and four a corner.");
}

TEST_CASE("nothing farther is, and nobody is his own neighbour", "[task-1][one-step]") {
    expect_steps(too_far(), "Columns and rows differ by one at most, and by something.");
}

TEST_CASE("no step leads off the map", "[task-1][on-the-map]") {
    expect_steps(off_the_map(), "Columns and rows begin at 0. What is outside cannot be asked whether it is a wall.");
}

TEST_CASE("no step leads into a wall or out of one", "[task-1][walls]") {
    expect_steps(into_walls(), "Both tiles of a step are free.");
}

TEST_CASE("nobody squeezes past a corner", "[task-1][corners]") {
    expect_steps(past_corners(),
                 "A step across a corner needs both tiles beside it: one who is as wide as a tile has no room there.");
}

TEST_CASE("all neighbours to which a step leads, and no others", "[task-2][all]") {
    expect_neighbours(without_shut(), "Each of the eight tiles around, if one may step to it.");
}

TEST_CASE("a step that is shut is shut in its own direction", "[task-2][one-way]") {
    expect_neighbours(
        with_shut(),
        "Down a cliff is a step, and up is none: only where both ends are equal, from and to, is it this one.");
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    if (task == 1) {
        for (const auto* all : {&on_open_ground(), &too_far(), &off_the_map(), &into_walls(), &past_corners()})
            for (const auto& a : *all) numbers.push_back(exercise::may_step(a.map, a.from, a.to));
        return numbers;
    }
    for (const auto* all : {&without_shut(), &with_shut()})
        for (const auto& a : *all) {
            for (const Tile t : sorted(exercise::neighbours(a.map, a.from))) numbers.push_back(100 * t.y + t.x);
            numbers.push_back(-1);
        }
    return numbers;
}
