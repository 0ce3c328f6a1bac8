// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Errand`, a start and a goal, and `first_meeting`, which holds the plans of several against each
/// other: what `Prioritised`, `ConflictBased` and `Windowed` have in common (notes 6.3: A* is a method for one agent).
///
/// A plan is a list of tiles, the k-th for step k; behind the last one its owner stays where it is. Two plans meet
/// where both are in one tile in the same step, where they change places, and where their diagonal steps cross.

#include <ansatz/core/error.hpp>
#include <ansatz/paths/grid/cell.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ansatz::paths {

/// A start and a goal.
struct Errand {
    Cell start; ///< in step 0
    Cell goal;  ///< and stays there
};

/// A step of one agent, or its waiting.
struct Move {
    Cell from;                                                  ///< when it begins
    Cell to;                                                    ///< one step later
    friend bool operator==(const Move&, const Move&) = default; ///< whether they are the same
};

/// Two agents that meet.
struct Meeting {
    /// How.
    enum class Kind : std::uint8_t {
        in_a_tile,     ///< both are where `one.from` is
        change_places, ///< each goes where the other was
        cross,         ///< their diagonal steps cross
    };
    std::size_t first = 0;  ///< one agent, by its place in the list
    std::size_t second = 0; ///< the other; behind the first
    std::uint32_t step = 0; ///< in which step; for agents that move, that in which their moves begin
    Kind kind{};            ///< how
    Move one;               ///< what the first does in that step
    Move other;             ///< what the second does
};

/// Where an agent is in a step of its plan.
inline Cell at_step(std::span<const Cell> plan, std::size_t step) { return plan[std::min(step, plan.size() - 1)]; }

/// Whether two moves that begin in one step meet on their way, or before it.
inline std::optional<Meeting::Kind> meet(const Move& a, const Move& b) {
    if (a.from == b.from) return Meeting::Kind::in_a_tile;
    if (a.from == b.to && a.to == b.from) return Meeting::Kind::change_places;
    const bool both_move = !(a.from == a.to) && !(b.from == b.to);
    // Lines of one length cross in the middle of both.
    if (both_move && a.from.x + a.to.x == b.from.x + b.to.x && a.from.y + a.to.y == b.from.y + b.to.y)
        return Meeting::Kind::cross;
    return std::nullopt;
}

namespace detail {
/// Where two plans meet first.
inline std::optional<Meeting> first_meeting(std::span<const Cell> a, std::span<const Cell> b, std::size_t first,
                                            std::size_t second) {
    const std::size_t steps = std::max(a.size(), b.size());
    for (std::size_t s = 0; s < steps; ++s) {
        const Move one{at_step(a, s), at_step(a, s + 1)}, other{at_step(b, s), at_step(b, s + 1)};
        if (const auto kind = meet(one, other)) return Meeting{first, second, std::uint32_t(s), *kind, one, other};
    }
    return std::nullopt;
}
/// \throws std::invalid_argument for no errand, for a tile outside the map, and for two who begin or end in one tile
template <class Map> void require_errands(const std::string& where, const Map& map, std::span<const Errand> errands) {
    if (errands.empty()) refuse_value(where, "the number of errands", "0", "there must be one at least");
    for (std::size_t i = 0; i < errands.size(); ++i) {
        for (const Cell c : {errands[i].start, errands[i].goal})
            if (!map.contains(c))
                refuse_value(where, "a tile of agent " + std::to_string(i), name_of(c),
                             "the map has " + map.size_in_words());
        for (std::size_t k = 0; k < i; ++k)
            if (errands[i].start == errands[k].start || errands[i].goal == errands[k].goal)
                refuse_value(where,
                             (errands[i].start == errands[k].start ? "the start of agents " : "the goal of agents ") +
                                 std::to_string(k) + " and " + std::to_string(i),
                             "one tile", "each needs its own");
    }
}
} // namespace detail

/// The first meeting of any two, by step and then by their places in the list; none where all keep clear of each other.
/// It tests every pair, and is meant for checks and for a dozen agents.
/// \param plans none of them empty
inline std::optional<Meeting> first_meeting(std::span<const std::vector<Cell>> plans) {
    std::optional<Meeting> earliest;
    for (std::size_t i = 0; i < plans.size(); ++i)
        for (std::size_t k = i + 1; k < plans.size(); ++k)
            if (const auto meeting = detail::first_meeting(plans[i], plans[k], i, k))
                if (!earliest || meeting->step < earliest->step) earliest = meeting;
    return earliest;
}

} // namespace ansatz::paths
