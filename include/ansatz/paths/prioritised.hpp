// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Prioritised`: plans for several agents on one grid, one after the other, each in space and time around the plans of
/// those before it (Erdmann and Lozano-Perez 1987; with waiting, Silver 2005; notes 6.3: A* is a method for one).
///
/// It takes time in proportion to the number of agents, where all at once would take it to its power. The price: the
/// order decides. An agent that is planned first does not make way, and for a later one there may then be no plan,
/// though together, or in another order, there is one; `find` says for which agent. Try another order, or for a few
/// agents `ConflictBased`, which finds the best plan for all if there is one.
///
/// An agent that has arrived stays there and is in the way. One that has not been planned yet is not: an earlier one
/// may walk over where it stands, and it must get out of the way in time.

#include <ansatz/paths/a_star.hpp>
#include <ansatz/paths/flow_field.hpp>
#include <ansatz/paths/heuristics/by.hpp>
#include <ansatz/paths/plans.hpp>
#include <ansatz/paths/reservations.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace ansatz::paths {

/// \tparam Map a Grid on even ground
template <class Map> class Prioritised {
public:
    static constexpr std::size_t nobody = std::size_t(-1); ///< no agent

    /// \param map read, never copied: it must live as long as this
    explicit Prioritised(const Map& map) : map_(&map), field_(map) {
        static_assert(
            std::is_same_v<typename Map::ground, Even>,
            "Ansatz paths: Prioritised plans in steps of one length; it needs even ground, Grid<Eight<>, Even>");
    }
    explicit Prioritised(const Map&&) = delete; // a map that is gone after this line

    /// Plans for all, in the order of the list.
    /// \return whether there is a plan for every agent; else those before failed() have one
    /// \throws std::invalid_argument for no errand, for a tile outside the map, and for two who begin or end in one tile
    bool find(std::span<const Errand> errands) {
        detail::require_errands("Prioritised::find", *map_, errands);
        reserved_.clear();
        plans_.assign(errands.size(), {});
        expanded_ = 0;
        failed_ = nobody;
        for (std::size_t i = 0; i < errands.size(); ++i)
            if (!find_one(errands[i], std::uint32_t(i))) {
                failed_ = i;
                return false;
            }
        return true;
    }
    /// Where an agent is in each step, from the first; behind the last it stays where it is. Empty for one that has no
    /// plan.
    /// \throws std::invalid_argument for an agent that was not among the errands
    const std::vector<Cell>& plan(std::size_t agent) const {
        if (agent >= plans_.size())
            refuse_value("Prioritised::plan", "agent", std::to_string(agent),
                         "the last search had " + std::to_string(plans_.size()) + " agents, counted from 0");
        return plans_[agent];
    }
    /// Where an agent is in a step.
    /// \throws std::invalid_argument for an agent that was not among the errands, or that has no plan
    Cell at(std::size_t agent, std::size_t step) const {
        const auto& cells = plan(agent);
        if (cells.empty())
            refuse_value("Prioritised::at", "agent", std::to_string(agent), "it must be one that has a plan; " + why());
        return at_step(cells, step);
    }
    std::size_t failed() const { return failed_; }                 ///< the first without a plan, or `nobody`
    std::size_t steps() const { return reserved_.last(); }         ///< until all stand
    std::size_t expanded() const { return expanded_; }             ///< nodes expanded, in space and time
    const Reservations& reservations() const { return reserved_; } ///< all plans together
    /// In a sentence, which agent has no plan.
    std::string why() const {
        if (failed_ == nobody) return "there is a plan for all " + std::to_string(plans_.size()) + " agents";
        return "there is no plan for agent " + std::to_string(failed_) + " around those of the " +
               std::to_string(failed_) + " before it; another order may have one";
    }

private:
    bool find_one(const Errand& errand, std::uint32_t agent) {
        if (field_.aim(errand.goal) != Outcome::found || !field_.reaches(errand.start)) return false;
        if (reserved_.owner(errand.start, 0) != Reservations::nobody) return false;
        const std::uint32_t from = reserved_.free_from(errand.goal); // it can stay from here on
        if (from == Reservations::for_ever) return false;
        const TimedGrid<Map> graph(*map_, reserved_);
        const auto there = [goal = errand.goal, from](const Timed& v) { return v.cell == goal && v.step >= from; };
        const auto left = [this](const Timed& v) { return field_.cost(v.cell); };
        AStar search{graph, GoalWhere{there}, By{left}};
        const Outcome outcome = search.find(Timed{errand.start, 0});
        expanded_ += search.expanded();
        if (outcome != Outcome::found) return false;
        for (const Timed& v : search.path()) plans_[agent].push_back(v.cell);
        reserved_.take(agent, plans_[agent]);
        return true;
    }
    const Map* map_;
    FlowField<Map> field_;
    Reservations reserved_;
    std::vector<std::vector<Cell>> plans_;
    std::size_t failed_ = nobody, expanded_ = 0;
};
/// `Prioritised{map}`.
template <class Map> Prioritised(const Map&) -> Prioritised<Map>;

} // namespace ansatz::paths
