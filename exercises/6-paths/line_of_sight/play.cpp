// SPDX-License-Identifier: BSL-1.0
// What a guard sees of a yard, by your line of sight and by the library's.

#include "play.hpp"
#include "subject.hpp"

#include <ansatz/paths/grid/from_rows.hpp>
#include <ansatz/paths/smoothing.hpp>

#include <cstddef>
#include <cstdint>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

using namespace ansatz;
using namespace ansatz::paths;

const exercise::Room yard{"................................", ".......####.....................",
                          "..........#.....#####...........", "..........#.........#...........",
                          "..........#.........#...........", "....#######.........#...........",
                          "................#####...........", "................................"};
const exercise::Tile guard{14, 4};

template <class Sees> double seen(const Sees& sees) {
    double count = 0;
    for (int y = 0; y < int(yard.size()); ++y)
        for (int x = 0; x < int(yard[0].size()); ++x) count += sees(exercise::Tile{x, y});
    return count;
}

int main() {
    const std::vector<std::string_view> views(yard.begin(), yard.end());
    const auto map = grid_from<Grid<>>(views);
    const auto cell = [](exercise::Tile t) { return Cell{std::uint16_t(t.x), std::uint16_t(t.y)}; };
    const auto yours = [](exercise::Tile t) { return exercise::sees(yard, guard, t); };
    const auto library = [&](exercise::Tile t) { return line_of_sight(map, cell(guard), cell(t)); };

    auto rows = yard;
    for (int y = 0; y < int(yard.size()); ++y)
        for (int x = 0; x < int(yard[0].size()); ++x) {
            const bool mine = yours({x, y});
            if (mine != library({x, y})) rows[std::size_t(y)][std::size_t(x)] = '?';
            else if (mine) rows[std::size_t(y)][std::size_t(x)] = 'o';
        }
    rows[std::size_t(guard.y)][std::size_t(guard.x)] = 'G';
    for (const auto& row : rows) std::cout << row << '\n';
    std::cout << "G is the guard, o what it sees, # a wall; ? is where you and the library disagree.\n\n";

    workbook::Play table("What the guard at (14, 4) sees of 32 x 8 tiles.", {"tiles seen"});
    table.timed("ns for all around");
    volatile double sink = 0;
    table.row("yours", {seen(yours)}, 1, [&] { sink = seen(yours); });
    table.row("library", {seen(library)}, 1, [&] { sink = seen(library); });
    return table.print();
}
