// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise.
#include <ansatz/paths/a_star.hpp>
#include <ansatz/paths/route.hpp>
#include <ansatz/paths/waypoints.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace exercise {

struct Event {
    std::size_t from = 0, to = 0;
    double before = 1, after = 1;
};

/// The library's routes read the graph itself, on which the event takes place while somebody walks.
inline bool asks(const std::vector<std::size_t>& path, std::size_t at, const Event& event, ansatz::paths::Replan rule) {
    using namespace ansatz;
    paths::Waypoints<> map;
    const std::size_t last = std::max({*std::max_element(path.begin(), path.end()), event.from, event.to});
    for (std::size_t v = 0; v <= last; ++v) map.add(metres(0, 0, 0)); // all in one place: roads may be of any length
    auto length = [](double cost) { return (std::isfinite(cost) ? cost : 1.0) * metre; };
    std::size_t road = 0;
    bool found = false;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        const bool this_one = path[i] == event.from && path[i + 1] == event.to;
        const std::size_t number = map.connect(path[i], path[i + 1], this_one ? length(event.before) : 1.0 * metre);
        if (this_one) road = number, found = true;
    }
    if (!found) road = map.connect(event.from, event.to, length(event.before));
    if (!std::isfinite(event.before)) map.set_road_passable(road, false);

    paths::AStar search{map};
    paths::Route route{search, rule};
    route.go(path.front(), path.back());
    while (route.here() != path[at]) route.step();
    if (!std::isfinite(event.after)) map.set_road_passable(road, false);
    else {
        map.set_length(road, length(event.after));
        map.set_road_passable(road, true);
    }
    return route.needs_new_path();
}
inline bool must_search(const std::vector<std::size_t>& path, std::size_t at, const Event& event) {
    return asks(path, at, event, ansatz::paths::Replan::when_touched);
}
inline bool should_search(const std::vector<std::size_t>& path, std::size_t at, const Event& event) {
    return asks(path, at, event, ansatz::paths::Replan::also_when_cheaper);
}

} // namespace exercise
