// SPDX-License-Identifier: BSL-1.0
// The gap of section 6.3.2, for five around their centre by your formation;
// beside the library's.

#include "play.hpp"
#include "subject.hpp"

#include <ansatz/paths/a_star.hpp>
#include <ansatz/paths/formation.hpp>
#include <ansatz/paths/grid/from_rows.hpp>
#include <ansatz/paths/grid/graph.hpp>
#include <ansatz/paths/heuristics.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

using namespace ansatz;

namespace {

const std::vector<std::string> rows{"..........#.........", "..........#.........", "....................",
                                    "..........#.........", "..........#.........", "..........#........."};
const exercise::Map your_map{rows};
const std::vector<exercise::Tile> your_members{{2, 3}, {1, 2}, {1, 4}, {0, 3}, {2, 5}};
const std::vector<paths::Cell> members{{2, 3}, {1, 2}, {1, 4}, {0, 3}, {2, 5}};
constexpr paths::Cell goal{17, 2};

/// Over all steps of the centre: how many places of its own the group has, how
/// many at least in a step, and the most tiles that one of them must go in a
/// step.
struct Result {
    double own = 0, least = 5, speed = 0;
};
Result yours(const std::vector<exercise::Tile>& way, const std::vector<exercise::Offset>& offsets) {
    Result r;
    std::vector<std::vector<exercise::Slot>> slots;
    for (const exercise::Tile centre : way) {
        slots.push_back(exercise::slots_at(your_map, centre, offsets));
        double own = 0;
        for (const auto& slot : slots.back()) own += !slot.blocked;
        r.own += own, r.least = std::min(r.least, own);
    }
    for (const int speed : exercise::catch_up_speeds(slots)) r.speed = std::max(r.speed, double(speed));
    return r;
}
Result library(const auto& map, const std::vector<paths::Cell>& way, const paths::Formation& squad) {
    Result r;
    std::vector<paths::Slot> slots, before;
    for (const paths::Cell centre : way) {
        squad.at(map, centre, slots);
        double own = 0;
        for (const auto& slot : slots) own += !slot.blocked;
        r.own += own, r.least = std::min(r.least, own);
        for (std::size_t i = 0; i < before.size(); ++i) {
            const int columns = std::abs(int(slots[i].cell.x) - before[i].cell.x);
            r.speed = std::max(r.speed, double(std::max(columns, std::abs(int(slots[i].cell.y) - before[i].cell.y))));
        }
        std::swap(slots, before);
    }
    return r;
}

} // namespace

int main() {
    workbook::Play table("Five walk through a gap in a wall, in formation around their centre.",
                         {"own places in all", "in the gap", "catch-up speed, tiles a step"});
    table.timed("ns a path");
    const auto map = paths::grid_from<paths::Grid<>>({rows.begin(), rows.end()});
    paths::AStar search{map, paths::Octile{}};

    const auto mine = exercise::around_centre(your_members);
    search.find({std::uint16_t(mine.centre.x), std::uint16_t(mine.centre.y)}, goal);
    std::vector<exercise::Tile> your_way;
    for (const paths::Cell c : search.path()) your_way.push_back({c.x, c.y});
    const Result r = yours(your_way, mine.offsets);
    table.row("yours", {r.own, r.least, r.speed}, 1, [&] { yours(your_way, mine.offsets); });

    const auto [squad, centre] = paths::Formation::around_centre(members);
    search.find(centre, goal);
    const std::vector<paths::Cell> way(search.path().begin(), search.path().end());
    const Result l = library(map, way, squad);
    table.row("library", {l.own, l.least, l.speed}, 1, [&, &squad = squad] { library(map, way, squad); });
    return table.print();
}
