// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Maps and searches drawn in letters, for the terminal, and as points and lines, for a picture.
///
/// S start, G goal, # wall, x closed list, o open list, * path, . what the search knows nothing of.

#include <ansatz/paths/grid/grid.hpp>
#include <ansatz/units.hpp>
#include <ansatz/units/print.hpp>

#include "plot.hpp"

#include <cstddef>
#include <iomanip>
#include <iostream>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace drawing {

using ansatz::paths::Cell;
using Rows = std::vector<std::string>;

/// A map in letters. `letter(cell)` says what stands at a tile that is no wall.
template <class Map, class Letter> Rows map_of(const Map& map, Letter letter) {
    Rows rows;
    for (std::uint16_t y = 0; y < map.height(); ++y) {
        rows.emplace_back();
        for (std::uint16_t x = 0; x < map.width(); ++x) {
            const Cell at{x, y};
            rows.back() += map.passable(at) ? letter(at) : '#';
        }
    }
    return rows;
}
/// The lists of a search in letters.
template <class Map, class Search> Rows lists_of(const Map& map, const Search& search, Cell start, Cell goal) {
    return map_of(map, [&](Cell c) {
        return c == start ? 'S' : c == goal ? 'G' : search.is_closed(c) ? 'x' : search.is_open(c) ? 'o' : '.';
    });
}
/// Writes a path into a drawing; start and goal keep their letters.
inline Rows with_path(Rows rows, std::span<const Cell> path, char letter = '*') {
    for (std::size_t i = 1; i + 1 < path.size(); ++i) rows[path[i].y][path[i].x] = letter;
    return rows;
}
/// Prints a drawing with a text to the right of each of its rows.
inline void print(const Rows& rows, const Rows& texts = {}) {
    for (std::size_t i = 0; i < std::max(rows.size(), texts.size()); ++i) {
        std::string line = "  " + (i < rows.size() ? rows[i] : std::string(rows.empty() ? 0 : rows[0].size(), ' '));
        if (i < texts.size() && !texts[i].empty()) line += "   " + texts[i];
        std::cout << line << '\n';
    }
}
/// Prints drawings side by side, each below its title.
inline void print_beside(const std::vector<std::string>& titles, const std::vector<Rows>& drawings) {
    std::vector<std::size_t> widths;
    for (std::size_t i = 0; i < drawings.size(); ++i)
        widths.push_back(std::max(titles[i].size(), drawings[i][0].size()) + 3);
    auto padded = [](std::string text, std::size_t width) {
        return text.append(width > text.size() ? width - text.size() : 0, ' ');
    };
    auto line = [](std::string text) { // without blanks at its end
        text.erase(text.find_last_not_of(' ') + 1);
        std::cout << text << '\n';
    };
    std::string head = "  ";
    for (std::size_t i = 0; i < titles.size(); ++i) head += padded(titles[i], widths[i]);
    line(head);
    for (std::size_t y = 0; y < drawings[0].size(); ++y) {
        std::string text = "  ";
        for (std::size_t i = 0; i < drawings.size(); ++i) text += padded(drawings[i][y], widths[i]);
        line(text);
    }
}

/// Centres of tiles for a picture, whose second axis points upwards while rows grow downwards.
struct Places {
    std::vector<ansatz::Quantity<ansatz::unit::Length>> east, north;
    template <class Map> void add(const Map& map, Cell c) {
        const auto at = map.position(c);
        east.push_back(ansatz::x(at));
        north.push_back(double(map.height()) * map.tile() - ansatz::y(at));
    }
};
template <class Map, class Cells> Places places(const Map& map, const Cells& cells) {
    Places all;
    for (const Cell c : cells) all.add(map, c);
    return all;
}
/// The tiles on which one may walk, or the walls.
template <class Map> std::vector<Cell> cells(const Map& map, bool free) {
    std::vector<Cell> all;
    for (std::uint16_t y = 0; y < map.height(); ++y)
        for (std::uint16_t x = 0; x < map.width(); ++x)
            if (map.passable(Cell{x, y}) == free) all.push_back(Cell{x, y});
    return all;
}
/// The axes of a picture of a map.
template <class Map> ansatz::workbook::Plot& on_map(ansatz::workbook::Plot& plot, const Map& map) {
    const auto none = 0.0 * ansatz::metre;
    return plot.x("east")
        .y("north")
        .equal_axes()
        .x_range(none, double(map.width()) * map.tile())
        .y_range(none, double(map.height()) * map.tile());
}
/// Tiles of a map, filled. The first are dark, and what comes later lies over them.
template <class Map, class Cells>
ansatz::workbook::Plot& fill(ansatz::workbook::Plot& plot, const Map& map, std::string name, const Cells& cells) {
    const auto all = places(map, cells);
    return plot.tiles(std::move(name), all.east, all.north, map.tile());
}
/// A map as a map: its walls are filled.
template <class Map>
ansatz::workbook::Plot& with_walls(ansatz::workbook::Plot& plot, const Map& map, std::string name = "wall") {
    const auto all = places(map, cells(map, false));
    return on_map(plot, map).tiles(std::move(name), all.east, all.north, map.tile());
}
/// A line from tile to tile.
template <class Map, class Cells>
ansatz::workbook::Plot& way(ansatz::workbook::Plot& plot, const Map& map, std::string name, const Cells& cells) {
    const auto all = places(map, cells);
    return plot.line(std::move(name), all.east, all.north);
}
/// Middles of tiles in a film, of a map whose upper left corner lies there.
template <class Map, class Cells>
auto in_film(const Map& map, const Cells& cells,
             const ansatz::VectorQuantity<ansatz::unit::Length>& corner = ansatz::metres(0, 0, 0)) {
    std::vector<ansatz::VectorQuantity<ansatz::unit::Length>> all;
    for (const Cell c : cells) all.push_back(corner + map.tile() * ansatz::Vector<double, 3>(c.x + 0.5, -c.y - 0.5, 0));
    return all;
}
/// Where somebody sets out, and where it wants to be.
template <class Map>
ansatz::workbook::Plot& with_ends(ansatz::workbook::Plot& plot, const Map& map, Cell start, Cell goal) {
    const auto from = places(map, std::vector<Cell>{start}), to = places(map, std::vector<Cell>{goal});
    return plot.points("start", from.east, from.north).points("goal", to.east, to.north);
}
/// A map with a path from its start to its goal.
template <class Map, class Cells>
ansatz::workbook::Plot& with_walls_and_path(ansatz::workbook::Plot& plot, const Map& map, const Cells& path) {
    with_walls(plot, map);
    return with_ends(way(plot, map, "path", path), map, path.front(), path.back());
}

} // namespace drawing
