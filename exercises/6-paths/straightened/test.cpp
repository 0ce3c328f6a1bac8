// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on a path that is pulled straight (notes 6.1.3).

#include "tools/exercises/expect.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

using namespace ansatz::workbook;
using exercise::Map;
using exercise::Tile;

namespace {

std::string said(Tile t) { return "(" + std::to_string(t.x) + ", " + std::to_string(t.y) + ")"; }
std::string said(const std::vector<Tile>& tiles) {
    std::string text;
    for (const Tile t : tiles) text += (text.empty() ? "" : " ") + said(t);
    return text.empty() ? "none" : text;
}
/// The map with its columns and rows counted. A mark on a tile would hide what it weighs.
std::string drawn(const Map& map) {
    std::string text = "      ";
    for (std::size_t x = 0; x < map[0].size(); ++x) text += char('0' + x % 10);
    for (std::size_t y = 0; y < map.size(); ++y) text += "\n    " + std::to_string(y) + ' ' + map[y];
    return text + '\n';
}
int weighs(const Map& map, Tile t) {
    if (t.x < 0 || t.y < 0 || t.y >= int(map.size()) || t.x >= int(map[0].size())) return 0;
    const char c = map[std::size_t(t.y)][std::size_t(t.x)];
    return c == '#' ? 0 : c == '.' ? 1 : c - '0';
}
std::vector<Tile> tiles_of(const Map& map) {
    std::vector<Tile> tiles;
    for (int y = 0; y < int(map.size()); ++y)
        for (int x = 0; x < int(map[0].size()); ++x) tiles.push_back({x, y});
    return tiles;
}

/// Grass of weight 2, with a swamp of 4, mud of 3, a road of 1, and a few walls.
const Map country{"2222244422", "2222.44#22", "22#2.44422", "2222.22222", "....333322", "2#22333222"};
const Map road{"33333333", "#......#"};
const Map plain{"......", "......", "......", "......"};
const Map pillar{".......", ".......", "...#...", ".......", "......."};

struct Walk {
    std::vector<Tile> corners;
    double right; // what it costs on `country`
};
const Walk of_one_part[] = {{{{0, 0}, {3, 0}}, 6.0},
                            {{{9, 3}, {9, 0}}, 6.0},
                            {{{0, 0}, {3, 1}}, 2 * std::sqrt(10.0)},
                            {{{8, 3}, {9, 1}}, 2 * std::sqrt(5.0)}};
const Walk of_other_ground[] = {{{{4, 0}, {6, 1}}, 4 * std::sqrt(5.0)},
                                {{{6, 2}, {5, 3}}, 2 * std::sqrt(2.0)},
                                {{{3, 3}, {4, 3}}, 1.0},
                                {{{3, 4}, {6, 5}}, 3 * std::sqrt(10.0)}};
const Walk of_several[] = {
    {{{0, 4}, {3, 4}, {6, 4}, {7, 5}, {9, 4}}, 3.0 + 9.0 + 2 * std::sqrt(2.0) + 2 * std::sqrt(5.0)},
    {{{0, 3}, {3, 3}, {4, 2}, {6, 1}, {6, 2}, {6, 3}}, 6.0 + std::sqrt(2.0) + 4 * std::sqrt(5.0) + 4.0 + 2.0}};
const Walk of_none[] = {{{{0, 0}}, 0.0}, {{{6, 1}}, 0.0}, {{}, 0.0}};
template <class Walks> void expect_walks(const Walks& walks, const char* why) {
    for (const Walk& walk : walks) {
        const double yours = exercise::walk_cost(country, walk.corners);
        expect_near("the map\n" + drawn(country) + "what the walk costs from corner to corner: " + said(walk.corners),
                    yours, walk.right, 1e-12, why);
    }
}

struct Ends {
    Tile from, to;
};
int length(const Ends& e) { return std::abs(e.to.x - e.from.x) + std::abs(e.to.y - e.from.y); }
/// All there are, the shortest first, so that what fails is as small as it can be.
std::vector<Ends> pairs(const Map& map) {
    std::vector<Ends> all;
    for (const Tile from : tiles_of(map))
        for (const Tile to : tiles_of(map)) all.push_back({from, to});
    std::stable_sort(all.begin(), all.end(), [](const Ends& a, const Ends& b) { return length(a) < length(b); });
    return all;
}
/// How far the square of a tile is from the line: less than 0 if that goes through it, 0 if it touches a corner.
int distance(const Ends& e, Tile t) {
    const auto [from, to] = e;
    if (from == to) return t == from ? -1 : 1;
    const int dx = to.x - from.x, dy = to.y - from.y;
    const int across = std::abs(2 * (dx * (t.y - from.y) - dy * (t.x - from.x))) - (std::abs(dx) + std::abs(dy));
    const int left = 2 * std::min(from.x, to.x) - (2 * t.x + 1), right = 2 * t.x - 1 - 2 * std::max(from.x, to.x);
    const int above = 2 * std::min(from.y, to.y) - (2 * t.y + 1), below = 2 * t.y - 1 - 2 * std::max(from.y, to.y);
    return std::max({across, left, right, above, below});
}
bool right_line(const Map& map, const Ends& e) {
    const auto all = tiles_of(map);
    return std::none_of(all.begin(), all.end(), [&](Tile t) {
        const int far = distance(e, t);
        return (far <= 0 && weighs(map, t) == 0) || (far < 0 && !(t == e.from) && weighs(map, t) != weighs(map, e.to));
    });
}
void expect_line(const Map& map, Tile from, Tile to, bool right, const std::string& why) {
    const bool yours = exercise::even_line(map, from, to);
    if (yours == right) return; // without a text: all lines of all maps are asked for
    const auto word = [](bool yes) { return yes ? "even" : "not even"; };
    fail("the map\n" + drawn(map) + "the line from " + said(from) + " to " + said(to) + "\n    yours  " + word(yours) +
         "\n    right  " + word(right) + "\n" + why);
}

/// Maps with walls and weights at random, in patches of 2 x 2 tiles.
const std::vector<Map>& maps() {
    static const std::vector<Map> all = [] {
        std::vector<Map> made{country, pillar};
        std::uint32_t seed = 5;
        const auto dice = [&](unsigned sides) { return ((seed = seed * 1664525u + 1013904223u) >> 8) % sides; };
        for (const unsigned walls : {0u, 8u, 15u}) {
            Map map(8, std::string(10, '.'));
            for (std::size_t y = 0; y < map.size(); ++y)
                for (std::size_t x = 0; x < map[y].size(); ++x)
                    map[y][x] = y % 2 ? map[y - 1][x] : x % 2 ? map[y][x - 1] : "...23"[dice(5)];
            for (auto& row : map)
                for (char& tile : row)
                    if (dice(100) < walls) tile = '#';
            made.push_back(map);
        }
        return made;
    }();
    return all;
}

std::array<Tile, 8> around(Tile t) {
    return {{{t.x - 1, t.y - 1},
             {t.x, t.y - 1},
             {t.x + 1, t.y - 1},
             {t.x - 1, t.y},
             {t.x + 1, t.y},
             {t.x - 1, t.y + 1},
             {t.x, t.y + 1},
             {t.x + 1, t.y + 1}}};
}
/// The cheapest path along the tiles, by Dijkstra's algorithm in whole numbers; none where there is no way.
std::vector<Tile> cheapest(const Map& map, const Ends& e) {
    const auto all = tiles_of(map);
    const int columns = int(map[0].size());
    const auto number = [&](Tile t) { return std::size_t(t.y * columns + t.x); };
    const long none = 1000000000;
    std::vector<long> cost(all.size(), none);
    std::vector<std::size_t> parent(all.size(), all.size());
    std::vector<char> closed(all.size()); // not of bool, which is slow where nothing is optimised
    if (weighs(map, e.from) && weighs(map, e.to)) cost[number(e.to)] = 0;
    for (;;) { // from the goal: a step is paid by the tile that is entered, which is the one nearer to the goal
        std::size_t best = all.size();
        for (std::size_t i = 0; i < all.size(); ++i)
            if (!closed[i] && cost[i] < none && (best == all.size() || cost[i] < cost[best])) best = i;
        if (best == all.size() || best == number(e.from)) break;
        closed[best] = true;
        const Tile b = all[best];
        for (const Tile a : around(b)) {
            if (!weighs(map, a) || !weighs(map, {a.x, b.y}) || !weighs(map, {b.x, a.y})) continue;
            const long sum = cost[best] + (a.x != b.x && a.y != b.y ? 14142 : 10000) * weighs(map, b);
            if (sum < cost[number(a)]) cost[number(a)] = sum, parent[number(a)] = best;
        }
    }
    std::vector<Tile> path;
    if (cost[number(e.from)] < none)
        for (std::size_t i = number(e.from); i < all.size(); i = parent[i]) path.push_back(all[i]);
    return path;
}
struct Way {
    Map map;
    std::vector<Tile> path;
};
/// Cheapest paths of each map, the shortest first.
const std::vector<Way>& ways() {
    static const std::vector<Way> all = [] {
        std::vector<Way> made;
        for (const Map& map : maps())
            for (const Ends& e : pairs(map))
                if (length(e) > 3 && (e.from.x + 7 * e.from.y + 3 * e.to.x + 5 * e.to.y) % 13 == 0)
                    if (Way way{map, cheapest(map, e)}; way.path.size() > 2) made.push_back(way);
        std::stable_sort(made.begin(), made.end(),
                         [](const Way& a, const Way& b) { return a.path.size() < b.path.size(); });
        return made;
    }();
    return all;
}
double right_cost(const Map& map, const std::vector<Tile>& corners) {
    double sum = 0;
    for (std::size_t i = 1; i < corners.size(); ++i)
        sum += weighs(map, corners[i]) *
               std::sqrt(std::pow(corners[i].x - corners[i - 1].x, 2) + std::pow(corners[i].y - corners[i - 1].y, 2));
    return sum;
}
std::vector<Tile> right_corners(const Way& way) {
    std::vector<Tile> corners;
    for (std::size_t i = 0; i < way.path.size();) {
        corners.push_back(way.path[i]);
        // The end of the part of the path that is of one weight, and from there back to what can be reached.
        std::size_t k = i + 1;
        while (k + 1 < way.path.size() && weighs(way.map, way.path[k + 1]) == weighs(way.map, way.path[k])) ++k;
        while (k > i + 1 && k < way.path.size() && !right_line(way.map, {way.path[i], way.path[k]})) --k;
        i = k;
    }
    return corners;
}
void expect_corners(const Way& way, const std::vector<Tile>& right, const std::string& why) {
    const auto yours = exercise::smooth(way.map, way.path);
    if (yours == right) return;
    fail("the map\n" + drawn(way.map) + "the corners of the path " + said(way.path) + "\n    yours  " + said(yours) +
         "\n    right  " + said(right) + "\n" + why);
}

const Way open_ground[] = {{plain, {{0, 0}, {1, 0}, {2, 1}, {3, 1}, {4, 2}, {5, 2}}},
                           {plain, {{5, 3}, {4, 3}, {3, 2}, {2, 1}, {1, 1}}},
                           {plain, {{1, 0}, {2, 0}, {3, 0}, {4, 0}}}};
const Way past_the_pillar{pillar, {{1, 2}, {2, 3}, {3, 3}, {4, 3}, {5, 4}}};
const Way round_the_pillar{pillar, {{2, 2}, {2, 3}, {3, 3}, {4, 3}, {4, 2}, {4, 1}}};
const Way changes[] = {{country, {{2, 3}, {3, 3}, {4, 3}, {4, 2}, {4, 1}, {5, 1}, {6, 0}}},
                       {country, {{6, 1}, {6, 2}, {6, 3}, {7, 3}, {8, 4}, {9, 5}}},
                       {country, {{0, 5}, {0, 4}, {1, 4}, {2, 4}, {3, 4}, {4, 5}, {5, 5}, {6, 4}, {7, 3}, {8, 3}}},
                       {road, {{0, 0}, {1, 0}, {2, 1}, {3, 1}, {4, 1}, {5, 1}, {6, 0}, {7, 0}}}};

} // namespace

TEST_CASE("a part costs its length times the weight of its ground", "[task-1][part]") {
    expect_walks(of_one_part,
                 "The length is that of the straight line between the two centres. All of this ground weighs 2.");
}

TEST_CASE("what is entered is paid for, and not what is left", "[task-1][entered]") {
    expect_walks(of_other_ground, "Only the first tile weighs something else, and that is left.");
}

TEST_CASE("a walk costs the sum of its parts", "[task-1][sum]") {
    expect_walks(of_several, "Each part has a length and a weight of its own.");
}

TEST_CASE("whoever stands still pays nothing", "[task-1][nothing]") {
    expect_walks(of_none, "Without a second corner nothing is entered.");
}

TEST_CASE("on ground of one weight only walls are in the way", "[task-2][walls]") {
    expect_line(plain, {0, 0}, {5, 2}, true, "Nothing is in between.");
    expect_line(plain, {2, 2}, {2, 2}, true, "Where one is, one need not walk.");
    expect_line(pillar, {0, 2}, {6, 2}, false, "The line goes through the wall.");
    expect_line(pillar, {0, 0}, {6, 3}, false, "The line cuts off a corner of the wall.");
    expect_line(pillar, {0, 1}, {6, 0}, true, "The line passes the wall.");
    for (const Tile t : {Tile{2, 2}, {0, 0}}) {
        expect_line(pillar, t, {3, 2}, false, "It leads into a wall.");
        expect_line(pillar, {3, 2}, t, false, "It leads out of a wall.");
    }
}

TEST_CASE("nobody squeezes past the corner of a wall", "[task-2][squeeze]") {
    for (const Tile t : {Tile{3, 1}, {3, 3}}) {
        expect_line(pillar, {2, 2}, t, false, "One of the two tiles beside this diagonal step is a wall.");
        expect_line(pillar, t, {4, 2}, false, "One of the two tiles beside this diagonal step is a wall.");
    }
    expect_line(pillar, {1, 2}, {4, 3}, false, "The line goes exactly through a corner of the wall.");
}

TEST_CASE("a line across other ground is not even", "[task-2][ground]") {
    expect_line(country, {4, 0}, {9, 0}, false, "Between grass and grass, both of weight 2, lies the swamp.");
    expect_line(country, {3, 3}, {5, 3}, false, "It crosses the road. Ground that weighs less is other ground, too.");
    expect_line(country, {3, 1}, {5, 1}, false, "Onto the road and then into the swamp are two weights.");
    expect_line(country, {8, 3}, {5, 1}, false, "The last tile and those before it do not weigh the same.");
    expect_line(country, {5, 0}, {6, 2}, true, "All of it is swamp.");
}

TEST_CASE("what the first tile weighs does not matter", "[task-2][first]") {
    expect_line(country, {4, 1}, {6, 2}, true, "From the road into the swamp: all that is entered is swamp.");
    expect_line(country, {3, 3}, {4, 3}, true, "From grass onto the road: all that is entered is road.");
    expect_line(country, {4, 3}, {9, 3}, true, "From the road onto grass: all that is entered is grass.");
    expect_line(country, {6, 4}, {9, 4}, false, "From mud across mud onto grass: mud is entered, too.");
}

TEST_CASE("what only lies beside a diagonal step may weigh anything", "[task-2][beside]") {
    expect_line(country, {3, 4}, {4, 3}, true, "Grass and mud lie beside this step, and only the road is entered.");
    expect_line(country, {4, 0}, {5, 1}, true, "The road lies beside this step, and only the swamp is entered.");
    expect_line(country, {6, 3}, {7, 2}, true, "Grass lies beside this step, and only the swamp is entered.");
}

TEST_CASE("a line is even if all that it enters weighs the same", "[task-2][all]") {
    for (const Map& map : maps())
        for (const Ends& e : pairs(map))
            expect_line(map, e.from, e.to, right_line(map, e),
                        "The right answer was found by asking each tile of the map how far it is from the line.");
}

TEST_CASE("the first and the last tile are corners", "[task-3][ends]") {
    expect_corners({plain, {}}, {}, "No path, no corners.");
    expect_corners({plain, {{3, 1}}}, {{3, 1}}, "The first tile is the last one too, and there is one corner.");
    expect_corners({plain, {{3, 1}, {4, 2}}}, {{3, 1}, {4, 2}}, "There is nothing between the two.");
    expect_corners({country, {{3, 3}, {4, 3}}}, {{3, 3}, {4, 3}}, "There is nothing between the two.");
}

TEST_CASE("on open ground a zigzag becomes one line", "[task-3][zigzag]") {
    for (const Way& way : open_ground)
        expect_corners(way, {way.path.front(), way.path.back()},
                       "From the first tile an even line leads to the last one.");
}

TEST_CASE("from each corner on, as far as possible", "[task-3][round]") {
    expect_corners(round_the_pillar, {{2, 2}, {2, 3}, {4, 3}, {4, 1}},
                   "The next corner is searched for from the last one, not from where the path begins.");
}

TEST_CASE("behind a tile that cannot be reached one may be that can", "[task-3][behind]") {
    expect_corners(past_the_pillar, {{1, 2}, {5, 4}},
                   "The line to (4, 3) touches the wall's corner. The one to (5, 4) is clear, and the last that is.");
}

TEST_CASE("where the path comes onto other ground there is a corner", "[task-3][change]") {
    for (const Way& way : changes)
        expect_corners(way, right_corners(way),
                       "Each part is on ground of one weight: that of the tile which the path enters right after the "
                       "corner. Beyond other ground a later part begins.");
}

TEST_CASE("pulled straight, a cheapest path gets no dearer", "[task-3][dearer]") {
    for (const Way& way : ways()) {
        const auto yours = exercise::smooth(way.map, way.path);
        const double along = right_cost(way.map, way.path);
        const auto text = [&] {
            return "the map\n" + drawn(way.map) + "the path " + said(way.path) + "\nyour corners " + said(yours) + '\n';
        };
        for (std::size_t i = 1; i < yours.size(); ++i)
            if (!right_line(way.map, {yours[i - 1], yours[i]}))
                fail(text() + "The line from " + said(yours[i - 1]) + " to " + said(yours[i]) + " is not even.");
        const double straight = right_cost(way.map, yours);
        if (straight <= along + 1e-9) continue;
        std::ostringstream costs;
        costs << "Along the tiles it costs " << along << ", from corner to corner " << straight << ", which is more.";
        fail(text() + costs.str());
    }
}

TEST_CASE("the corners of many cheapest paths", "[task-3][all-paths]") {
    for (const Way& way : ways())
        expect_corners(way, right_corners(way),
                       "From each corner the path goes on over ground of one weight. The next corner is the last of "
                       "those tiles to which an even line leads.");
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    if (task == 1)
        for (const Way& way : ways()) {
            if (way.path.size() > 2) numbers.push_back(exercise::walk_cost(way.map, {way.path[0], way.path[1]}));
            numbers.push_back(exercise::walk_cost(way.map, way.path));
            numbers.push_back(exercise::walk_cost(way.map, right_corners(way)));
        }
    if (task == 2)
        for (const Map& map : maps())
            for (const Ends& e : pairs(map))
                if (length(e) < 7) numbers.push_back(exercise::even_line(map, e.from, e.to) ? 2 : 1);
    if (task == 3) {
        std::vector<Way> all = ways();
        all.insert(all.end(),
                   {open_ground[0], past_the_pillar, round_the_pillar, changes[0], changes[1], changes[2], changes[3]});
        for (const Way& way : all) {
            for (const Tile t : exercise::smooth(way.map, way.path))
                numbers.insert(numbers.end(), {2.0 + t.x, 3.0 + t.y});
            numbers.push_back(1);
        }
    }
    return numbers;
}
