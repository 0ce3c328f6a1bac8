// SPDX-License-Identifier: BSL-1.0
#pragma once

// Crowds at random, and a simulator that moves them and knows nothing of how their plans were made.

#include "tests/paths/support.hpp"

#include <ansatz/paths/cost.hpp>
#include <ansatz/paths/plans.hpp>

#include <algorithm>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace paths_tests {

using Plans = std::vector<std::vector<Cell>>;

inline Cell at(const std::vector<Cell>& plan, std::size_t step) { return plan[std::min(step, plan.size() - 1)]; }

/// Moves everybody, step by step, and says what goes wrong. It knows nothing of reservations.
template <class Map> std::string collision(const Map& map, const Plans& plans) {
    std::size_t steps = 0;
    for (const auto& plan : plans) steps = std::max(steps, plan.size());
    for (std::size_t s = 0; s <= steps; ++s)
        for (std::size_t i = 0; i < plans.size(); ++i) {
            const Cell from = at(plans[i], s), to = at(plans[i], s + 1);
            if (!map.passable(from)) return "in a wall";
            if (!(from == to) && !map.passable(from, to)) return "through a wall";
            for (std::size_t k = 0; k < i; ++k) {
                const Cell other = at(plans[k], s), next = at(plans[k], s + 1);
                if (from == other) return "two in one tile";
                if (from == next && to == other) return "two change places";
                // Twice the middle of both steps: equal where their lines cross.
                const bool moves = !(from == to) && !(other == next);
                if (moves && from.x + to.x == other.x + next.x && from.y + to.y == other.y + next.y)
                    return "two cross each other";
            }
        }
    return "";
}
/// What a plan costs: straight steps and waiting alike, diagonal ones by their length, in a search's numbers.
inline std::uint64_t cost_of(const std::vector<Cell>& plan) {
    std::uint64_t sum = 0;
    for (std::size_t s = 1; s < plan.size(); ++s) {
        const bool diagonal = plan[s].x != plan[s - 1].x && plan[s].y != plan[s - 1].y;
        sum += diagonal ? Tile<std::uint32_t>::diagonal : Tile<std::uint32_t>::straight;
    }
    return sum;
}
/// Agents with starts and goals of their own.
template <class Map> std::vector<Errand> crowd(const Map& map, std::mt19937& random, std::size_t n) {
    std::vector<Errand> all;
    for (int tries = 0; tries < 500 && all.size() < n; ++tries) {
        const Errand one{random_cell(random, map.width(), map.height()),
                         random_cell(random, map.width(), map.height())};
        const bool taken = std::any_of(all.begin(), all.end(), [&](const Errand& other) {
            return other.start == one.start || other.goal == one.goal;
        });
        if (map.passable(one.start) && map.passable(one.goal) && !taken) all.push_back(one);
    }
    return all;
}
template <class Search> Plans plans_of(const Search& search, std::size_t n) {
    Plans plans;
    for (std::size_t i = 0; i < n; ++i) plans.push_back(search.plan(i));
    return plans;
}

} // namespace paths_tests
