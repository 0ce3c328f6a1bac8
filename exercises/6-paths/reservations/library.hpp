// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise: its Reservations, and its grid in space and time.
#include <ansatz/paths/plans.hpp>
#include <ansatz/paths/reservations.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace exercise {

struct Place {
    int x = 0, y = 0;
    bool operator==(const Place&) const = default;
};
using Plan = std::vector<Place>;
using Room = std::vector<std::string>;

inline ansatz::paths::Cell cell(Place p) { return {std::uint16_t(p.x), std::uint16_t(p.y)}; }
inline Place place(ansatz::paths::Cell c) { return {c.x, c.y}; }
inline std::vector<ansatz::paths::Cell> cells(const Plan& plan) {
    std::vector<ansatz::paths::Cell> all;
    for (const Place p : plan) all.push_back(cell(p));
    return all;
}
inline ansatz::paths::Reservations taken(const std::vector<Plan>& reserved) {
    ansatz::paths::Reservations all;
    for (std::size_t i = 0; i < reserved.size(); ++i) all.take(std::uint32_t(i), cells(reserved[i]));
    return all;
}
inline Place place_at(const Plan& plan, std::size_t step) { return place(ansatz::paths::at_step(cells(plan), step)); }
inline bool is_free(const std::vector<Plan>& reserved, Place from, Place to, std::size_t step) {
    return taken(reserved).is_free(cell(from), cell(to), std::uint32_t(step));
}
inline std::vector<Place> next_places(const Room& room, const std::vector<Plan>& reserved, Place at, std::size_t step) {
    using namespace ansatz::paths;
    Grid<Four> map(room[0].size(), room.size());
    for (std::size_t y = 0; y < room.size(); ++y)
        for (std::size_t x = 0; x < room[y].size(); ++x) map.set_passable(cell({int(x), int(y)}), room[y][x] == '.');
    const auto all = taken(reserved);
    const TimedGrid graph{map, all, std::uint32_t(step + 1)}; // waiting is told from standing still
    const auto edges = out_edges(Timed{cell(at), std::uint32_t(step)}, graph);
    std::vector<Place> next;
    for (auto edge = edges.first; edge != edges.second; ++edge) next.push_back(place(target(*edge, graph).cell));
    return next;
}
inline bool can_stay(const std::vector<Plan>& reserved, Place goal, std::size_t step) {
    return taken(reserved).free_from(cell(goal)) <= step;
}

} // namespace exercise
