// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Windowed`: a crowd on one grid that plans a few steps ahead, walks half of them and plans again (windowed
/// cooperative A*, Silver 2005; notes 6.3: A* is a method for a single agent).
///
/// ```
/// Windowed crowd{map};
/// crowd.begin(errands);
/// while (!crowd.all_arrived() && crowd.stalled() < 100) crowd.step();      // crowd.at(agent): where it is now
/// ```
///
/// In the window each agent plans around those before it, as `Prioritised` does; behind the window it counts what is
/// left without the others. So a plan costs the same however far the goals are, goals may change at any step
/// (`set_goal`), and an agent at its goal makes way and comes back. Each is first in turn, and one that finds no plan
/// is first at once; where no order helps all wait for a step. Nobody ever meets anybody. The price: nothing says that
/// all arrive, for a window does not see a corridor that is longer; `stalled()` tells. For one plan that is known to
/// lead to the goals take `Prioritised`, for the best one `ConflictBased`.

#include <ansatz/paths/a_star.hpp>
#include <ansatz/paths/flow_field.hpp>
#include <ansatz/paths/heuristics/by.hpp>
#include <ansatz/paths/plans.hpp>
#include <ansatz/paths/reservations.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace ansatz::paths {

namespace detail {
/// As on the grid, but to wait at the goal costs nothing.
struct WindowWeights {
    using key_type = TimedEdge;
    using value_type = std::uint32_t;
    using reference = std::uint32_t;
    using category = boost::readable_property_map_tag;
    Cell goal;
    friend std::uint32_t get(const WindowWeights& map, const TimedEdge& e) {
        if (e.from.cell == map.goal && e.to.cell == map.goal) return 0;
        return e.diagonal ? Tile<std::uint32_t>::diagonal : Tile<std::uint32_t>::straight;
    }
};
} // namespace detail

/// \tparam Map a Grid on even ground
template <class Map> class Windowed {
public:
    /// \param map    read, never copied: it must live as long as this
    /// \param window how many steps are planned ahead; half of them are walked before the next plan
    /// \throws std::invalid_argument for a window of less than two steps
    explicit Windowed(const Map& map, std::uint32_t window = 16) : map_(&map), window_(window) {
        static_assert(std::is_same_v<typename Map::ground, Even>,
                      "Ansatz paths: Windowed plans in steps of one length; it needs even ground, Grid<Eight<>, Even>");
        if (window < 2 || window > 10000)
            refuse_value("Windowed", "the window", std::to_string(window), "it must be from 2 to 10000 steps");
    }
    explicit Windowed(const Map&&, std::uint32_t = 16) = delete; // a map that is gone after this line

    /// Sets each agent down at its start.
    /// \throws std::invalid_argument for no errand, for a tile outside the map or a start that is blocked, and for two
    ///         that begin or end in one tile; everything is as before
    void begin(std::span<const Errand> errands) {
        detail::require_errands("Windowed::begin", *map_, errands);
        for (std::size_t i = 0; i < errands.size(); ++i)
            if (!map_->passable(errands[i].start))
                refuse_value("Windowed::begin", "the start of agent " + std::to_string(i), name_of(errands[i].start),
                             "it must be passable");
        agents_.resize(errands.size(), Agent{{}, {}, FlowField<Map>(*map_), {}});
        for (std::size_t i = 0; i < errands.size(); ++i) {
            agents_[i].at = errands[i].start;
            agents_[i].goal = errands[i].goal;
            agents_[i].field.aim(errands[i].goal);
        }
        order_.resize(errands.size());
        std::iota(order_.begin(), order_.end(), 0u);
        walked_ = window_, steps_ = expanded_ = 0;
        look_how_far();
        stalled_ = 0;
    }
    /// Another goal for one of them, from the next step on.
    /// \throws std::invalid_argument for an agent that there is not, for a tile outside the map, and for the goal of
    ///         another
    void set_goal(std::size_t agent, Cell goal) {
        require_agent("Windowed::set_goal", agent);
        if (!map_->contains(goal))
            refuse_value("Windowed::set_goal", "the goal", name_of(goal), "the map has " + map_->size_in_words());
        for (std::size_t i = 0; i < agents_.size(); ++i)
            if (i != agent && agents_[i].goal == goal)
                refuse_value("Windowed::set_goal", "the goal", name_of(goal),
                             "it is that of agent " + std::to_string(i) + "; each needs its own");
        agents_[agent].goal = goal;
        agents_[agent].field.aim(goal);
        walked_ = window_;
        look_how_far();
        stalled_ = 0;
    }
    /// Each agent goes on by one step, or waits.
    void step() {
        if (agents_.empty()) return;
        if (map_->version() != version_ || walked_ >= std::max(1u, window_ / 2)) look_ahead();
        ++walked_, ++steps_;
        for (auto& agent : agents_) agent.at = at_step(agent.plan, walked_);
        if (nearer()) stalled_ = 0;
        else ++stalled_;
    }
    /// Where one of them is.
    /// \throws std::invalid_argument for an agent that there is not
    Cell at(std::size_t agent) const { return agents_[require_agent("Windowed::at", agent)].at; }
    /// Where it wants.
    /// \throws std::invalid_argument for an agent that there is not
    Cell goal(std::size_t agent) const { return agents_[require_agent("Windowed::goal", agent)].goal; }
    /// Whether it is there; it may still make way for another.
    /// \throws std::invalid_argument for an agent that there is not
    bool arrived(std::size_t agent) const {
        const auto& one = agents_[require_agent("Windowed::arrived", agent)];
        return one.at == one.goal;
    }
    /// Whether all are.
    bool all_arrived() const {
        return std::all_of(agents_.begin(), agents_.end(), [](const Agent& one) { return one.at == one.goal; });
    }
    std::size_t size() const { return agents_.size(); } ///< how many there are
    std::size_t steps() const { return steps_; }        ///< walked since `begin`
    /// Steps since what is left to all of them, together, was less than ever before; it grows where an agent's goal
    /// cannot be reached, where two wait for each other, and where all have arrived.
    std::size_t stalled() const { return stalled_; }
    std::size_t expanded() const { return expanded_; } ///< nodes expanded in space and time since `begin`

private:
    struct Agent {
        Cell at, goal;
        FlowField<Map> field;   ///< to its goal
        std::vector<Cell> plan; ///< of this window
    };
    std::size_t require_agent(const char* where, std::size_t agent) const {
        if (agent >= agents_.size())
            refuse_value(where, "agent", std::to_string(agent),
                         "there are " + std::to_string(agents_.size()) + ", counted from 0");
        return agent;
    }
    /// What is left to all, where it can be known.
    std::uint64_t left() const {
        std::uint64_t sum = 0;
        for (const auto& agent : agents_)
            if (agent.field.reaches(agent.at)) sum += agent.field.cost(agent.at);
        return sum;
    }
    void look_how_far() { least_left_ = left(); }
    bool nearer() {
        const auto now = left();
        if (now >= least_left_) return false;
        least_left_ = now;
        return true;
    }
    /// Plans the next window for all.
    void look_ahead() {
        if (map_->version() != version_) {
            version_ = map_->version();
            for (auto& agent : agents_)
                if (!agent.field.is_current()) agent.field.aim(agent.goal);
            look_how_far();
            stalled_ = 0;
        }
        walked_ = 0;
        std::rotate(order_.begin(), order_.begin() + 1, order_.end());
        for (std::size_t attempt = 0; attempt <= agents_.size(); ++attempt) {
            const auto failed = plan_in_order();
            if (failed == order_.end()) return;
            std::rotate(order_.begin(), failed, failed + 1); // it is first
        }
        for (auto& agent : agents_) agent.plan.assign(1, agent.at);
        walked_ = window_ - 1; // all wait, and the next step searches again
    }
    /// \return the first that has no plan
    std::vector<std::uint32_t>::iterator plan_in_order() {
        reserved_.clear();
        for (auto who = order_.begin(); who != order_.end(); ++who) {
            Agent& agent = agents_[*who];
            if (reserved_.owner(agent.at, 0) != Reservations::nobody) return who;
            const TimedGrid graph(*map_, reserved_, window_);
            const auto there = [last = window_](const Timed& v) { return v.step == last; };
            // An agent whose goal is out of reach keeps its place.
            const Cell wanted = agent.field.reaches(agent.at) ? agent.goal : agent.at;
            const auto ahead = [&field = agent.field](const Timed& v) {
                return field.reaches(v.cell) ? field.cost(v.cell) : 0u;
            };
            AStar search{graph, GoalWhere{there}, By{ahead}, WeightsOf{detail::WindowWeights{wanted}}};
            const auto outcome = search.find(Timed{agent.at, 0});
            expanded_ += search.expanded();
            if (outcome != Outcome::found) return who;
            agent.plan.clear();
            for (const Timed& v : search.path()) agent.plan.push_back(v.cell);
            reserved_.take(*who, agent.plan);
        }
        return order_.end();
    }

    const Map* map_;
    std::uint32_t window_;
    std::vector<Agent> agents_;
    std::vector<std::uint32_t> order_; ///< which plans first
    Reservations reserved_;
    std::uint32_t walked_ = 0; ///< steps of this plan
    std::size_t steps_ = 0, stalled_ = 0, expanded_ = 0, version_ = std::size_t(-1);
    std::uint64_t least_left_ = 0;
};
/// `Windowed{map}`.
template <class Map> Windowed(const Map&) -> Windowed<Map>;
/// `Windowed{map, 32}`.
template <class Map> Windowed(const Map&, std::uint32_t) -> Windowed<Map>;

} // namespace ansatz::paths
