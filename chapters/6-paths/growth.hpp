// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Searches that grow over one map, each in a picture of its own, as a film.

#include <ansatz/paths/a_star.hpp>
#include <ansatz/units.hpp>

#include "drawing.hpp"
#include "film.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace drawing {

/// The lists of a search after each ten of its turns, and its path in the end.
struct Growth {
    static constexpr std::size_t turns = 10;
    std::string name;
    std::vector<std::vector<Cell>> closed = {}, open = {};
    std::vector<Cell> path = {};
    std::size_t expanded = 0;
};
/// Lets a search run to its end, ten turns at a time. There is a path.
template <class Search> Growth grow(std::string name, Search search, Cell start, Cell goal) {
    Growth growth{std::move(name)};
    search.begin(start, goal);
    for (bool running = true; running; search.advance(Growth::turns)) {
        growth.closed.push_back(search.closed_list());
        growth.open.push_back(search.open_list());
        running = search.outcome() == ansatz::paths::Outcome::running;
    }
    growth.path.assign(search.path().begin(), search.path().end());
    growth.expanded = search.expanded();
    return growth;
}

/// The frames of four searches, each on a map of its own, with its name, and how much it expanded when it is done. The
/// slowest is the first. The maps lie around 0 | 0, and a tile is a metre.
template <class Map>
void side_by_side(ansatz::workbook::Film& film, const Map& map, const std::array<Growth, 4>& searches) {
    using namespace ansatz;
    const workbook::Paint untouched{0xeef0f1, 0}, closed{0x7fb5d9, 0}, open{0xe9b44c, 0};
    const double wide = double(map.width()), high = double(map.height());
    const auto corner = [&](std::size_t k) {
        return metres(k % 2 == 0 ? -wide - 1.8 : 1.8, k < 2 ? high + 1 : -1.8, 0);
    };
    const auto on = [&](std::size_t k, const auto& tiles) { return in_film(map, tiles, corner(k)); };
    film.counts("turns").may_change();
    for (std::size_t k = 0; k < 4; ++k)
        film.scenery()
            .tiles(on(k, cells(map, true)), map.tile(), untouched)
            .tiles(on(k, cells(map, false)), map.tile(), workbook::paints::stone)
            .note(corner(k) + metres(0, 0.6, 0), searches[k].name);
    for (std::size_t n = 0; n < searches[0].closed.size(); ++n) {
        auto& frame = film.frame(double(n * Growth::turns) * second);
        for (std::size_t k = 0; k < 4; ++k) {
            const Growth& search = searches[k];
            const std::size_t last = search.closed.size() - 1, now = std::min(n, last);
            if (now > 0) frame.tiles(on(k, search.closed[now]), map.tile(), closed);
            frame.tiles(on(k, search.open[now]), map.tile(), open);
            frame.tiles(on(k, std::array{search.path.front(), search.path.back()}), map.tile(), workbook::paints::ball);
            if (n < last) continue; // it is still running
            frame.line(on(k, search.path), workbook::paints::wire);
            frame.note(corner(k) + metres(wide - 10.6, 0.6, 0), std::to_string(search.expanded) + " expanded");
        }
    }
}

} // namespace drawing
