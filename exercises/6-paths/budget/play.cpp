// SPDX-License-Identifier: BSL-1.0
// A castle whose door is on the far side, by your search in slices and your f; beside the library's.

#include "play.hpp"
#include "subject.hpp"

#include <ansatz/paths/a_star.hpp>
#include <ansatz/paths/grid/graph.hpp>
#include <ansatz/paths/heuristics.hpp>

#include <cstdlib>
#include <random>
#include <vector>

using namespace ansatz;
using namespace ansatz::paths;

namespace {

using Map = Grid<Four>;
constexpr std::uint16_t width = 96, height = 64;
constexpr Cell start{4, 40}, goal{76, 25};
constexpr std::size_t slice = 200;
constexpr double weight = 1.5;

/// The map of section 6.3.3, of four neighbours.
Map castle() {
    Map map(width, height);
    std::mt19937 random(6);
    for (std::uint16_t y = 0; y < height; ++y)
        for (std::uint16_t x = 0; x < width; ++x)
            if (random() % 100 < 12) map.set_passable(Cell{x, y}, false);
    for (std::uint16_t y = 20; y <= 30; ++y)
        for (std::uint16_t x = 70; x <= 82; ++x) map.set_passable(Cell{x, y}, y > 20 && y < 30 && x > 70 && x < 82);
    map.set_passable(Cell{82, 25}, true);
    map.set_passable(start, true);
    return map;
}
std::size_t number(Cell c) { return std::size_t(c.y) * width + c.x; }

/// What you are asked for, of this map.
exercise::Search yours(const Map& map) {
    exercise::Graph graph(std::size_t(width) * height);
    std::vector<double> h;
    for (std::uint16_t y = 0; y < height; ++y)
        for (std::uint16_t x = 0; x < width; ++x) {
            const Cell here{x, y};
            h.push_back(std::abs(x - goal.x) + std::abs(y - goal.y));
            if (!map.passable(here)) continue;
            const auto out = out_edges(here, map);
            for (auto edge = out.first; edge != out.second; ++edge)
                graph[number(here)].push_back({number(target(*edge, map)), 1.0});
        }
    return exercise::begin(std::move(graph), std::move(h), number(start), number(goal));
}
/// Your f in the library's search: what it adds to g is a heuristic, in the unit of the grid's weights.
By<double (*)(Cell, Cell)> your_heuristic() {
    return {[](Cell c, Cell to) {
        const double tiles = std::abs(c.x - to.x) + std::abs(c.y - to.y);
        return exercise::weighted_f(0, double(Tile<std::uint32_t>::straight) * tiles, weight);
    }};
}
struct Result {
    double frames = 0, cost = 0;
};
Result in_slices(exercise::Search search) {
    Result r;
    auto outcome = exercise::Outcome::running;
    for (; outcome == exercise::Outcome::running && r.frames < 1000; ++r.frames)
        outcome = exercise::advance(search, slice);
    r.cost = search.g[number(goal)];
    return r;
}
Result in_slices(auto& search) {
    Result r;
    search.begin(start, goal);
    do ++r.frames;
    while (search.advance(slice) == paths::Outcome::running);
    r.cost = double(search.path().size() - 1);
    return r;
}

} // namespace

int main() {
    const auto map = castle();
    workbook::Play table("Into a castle by the door on its far side, in slices of 200 nodes a frame.",
                         {"frames", "steps", "frames, w = 1.5", "steps, w = 1.5"});
    table.timed("ns a search");
    const auto plain = yours(map);
    AStar with_your_f{map, your_heuristic(), NoReopening{}};
    const Result mine = in_slices(plain), mine_hasty = in_slices(with_your_f);
    table.row("yours", {mine.frames, mine.cost, mine_hasty.frames, mine_hasty.cost}, 1, [&] { in_slices(plain); });

    AStar search{map, Manhattan{}};
    AStar hasty{map, Weighted{Manhattan{}, weight}, NoReopening{}};
    const Result theirs = in_slices(search), theirs_hasty = in_slices(hasty);
    table.row("library", {theirs.frames, theirs.cost, theirs_hasty.frames, theirs_hasty.cost}, 1,
              [&] { in_slices(search); });
    return table.print();
}
