// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// A crowd that walks over a map twice, side by side, as a film that shows who meets.

#include <ansatz/units.hpp>

#include "drawing.hpp"
#include "film.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace drawing {

/// A crowd: its name, and where each agent is after each step, agents[i][step]. One that has arrived stays.
struct Crowd {
    std::string name;
    std::vector<std::vector<Cell>> agents;

    Cell at(std::size_t i, std::size_t step) const { return agents[i][std::min(step, agents[i].size() - 1)]; }
    std::size_t steps() const {
        std::size_t most = 0;
        for (const auto& agent : agents) most = std::max(most, agent.size() - 1);
        return most;
    }
    /// The tiles in which two are after this step, or between which two changed places in it. The first step is 1.
    std::vector<Cell> meetings(std::size_t step) const {
        std::vector<Cell> all;
        for (std::size_t i = 0; i < agents.size(); ++i)
            for (std::size_t k = 0; k < i; ++k)
                if (at(i, step) == at(k, step) || (at(i, step) == at(k, step - 1) && at(i, step - 1) == at(k, step)))
                    all.push_back(at(i, step));
        return all;
    }
};

/// The frames of two crowds with the same goals, four a step. A tile is a metre, and the maps lie around 0 | 0.
template <class Map>
void walk_side_by_side(ansatz::workbook::Film& film, const Map& map, const std::array<Crowd, 2>& crowds) {
    using namespace ansatz;
    constexpr std::array colours{0xd55e00U, 0x0072b2U, 0x009e73U, 0xcc79a7U, 0xe69f00U, 0x56b4e9U,
                                 0x8c510aU, 0x5e3c99U, 0x8a1538U, 0x444444U, 0x80b918U, 0x01665eU,
                                 0xf08c78U, 0x1d3f8fU, 0x9a9a9aU, 0xc8b000U};
    const auto paint_of = [&](std::size_t i) { return workbook::Paint{colours.at(i), 0}; };
    const double wide = double(map.width()), high = double(map.height());
    const auto corner = [&](std::size_t k) { return metres(k == 0 ? -wide - 0.6 : 0.6, high / 2, 0); };
    const auto on = [&](std::size_t k, const auto& tiles) { return in_film(map, tiles, corner(k)); };
    const std::size_t steps = std::max(crowds[0].steps(), crowds[1].steps()), agents = crowds[0].agents.size();
    film.counts("steps").may_change();
    for (std::size_t k = 0; k < 2; ++k) {
        film.scenery()
            .tiles(on(k, cells(map, true)), map.tile(), {0xeef0f1, 0})
            .tiles(on(k, cells(map, false)), map.tile(), workbook::paints::stone)
            .note(corner(k) + metres(0, 0.2, 0), crowds[k].name);
        for (std::size_t i = 0; i < agents; ++i)
            film.scenery().ball(on(k, std::array{crowds[k].at(i, steps)})[0], 0.14 * metre, paint_of(i));
    }
    std::array<std::size_t, 2> met{};
    for (std::size_t step = 1; step <= steps; ++step)
        for (int quarter = step == 1 ? 0 : 1; quarter <= 4; ++quarter) { // the end of a step begins the next one
            auto& frame = film.frame((double(step) - 1 + quarter / 4.0) * second);
            for (std::size_t k = 0; k < 2; ++k) {
                const auto meetings = crowds[k].meetings(step);
                if (quarter == 4) met[k] += meetings.size();
                if (!meetings.empty() && quarter > 1) frame.tiles(on(k, meetings), map.tile(), {0xf2a09a, 0});
                for (std::size_t i = 0; i < agents; ++i) {
                    const auto way = on(k, std::array{crowds[k].at(i, step - 1), crowds[k].at(i, step)});
                    frame.ball(way[0] + quarter / 4.0 * (way[1] - way[0]), 0.36 * metre, paint_of(i));
                }
                frame.note(corner(k) + metres(wide - 2.3, 0.2, 0), "meetings: " + std::to_string(met[k]));
            }
        }
}

} // namespace drawing
