// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `ConflictBased`: the plans for several agents on one grid whose costs have the least sum (Sharon, Stern, Felner and
/// Sturtevant 2015; notes 6.3: A* is a method for a single agent).
///
/// Each agent is planned alone first. Where two meet, one of them has to give way: the search tries both, each as a
/// node of a tree, in which the one agent is planned again and must not do in that step what it did. The node whose
/// plans cost least is expanded next, so that the first without a meeting is the best there is.
///
/// Take it for a few agents, and to hold other methods against: it finds plans where `Prioritised` finds none, since
/// no agent has a rank, and its tree grows exponentially with the number of meetings. Where there is no plan the tree
/// may have no end; therefore `find` takes a budget. For a crowd take `Prioritised`, or `Windowed`.

#include <ansatz/paths/a_star.hpp>
#include <ansatz/paths/flow_field.hpp>
#include <ansatz/paths/heuristics/by.hpp>
#include <ansatz/paths/plans.hpp>
#include <ansatz/paths/reservations.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <tuple>
#include <type_traits>
#include <unordered_set>
#include <utility>
#include <vector>

namespace ansatz::paths {

/// What one agent must not do: tiles in a step, and moves that begin in a step. A table for `TimedGrid`.
class Forbidden {
public:
    /// Forgets all.
    void clear() { tiles_.clear(), moves_.clear(), last_ = 0; }
    /// It must not be here in this step.
    void forbid(Cell cell, std::uint32_t step) {
        tiles_.insert({cell, step});
        last_ = std::max(last_, step);
    }
    /// It must not begin this move in this step.
    void forbid(const Move& move, std::uint32_t step) {
        moves_.emplace_back(move, step);
        last_ = std::max(last_, step + 1);
    }
    /// Whether a move, or waiting, that begins in this step is allowed.
    bool is_free(Cell from, Cell to, std::uint32_t step) const {
        if (step >= last_) return true;
        if (tiles_.find({to, step + 1}) != tiles_.end()) return false;
        return std::none_of(moves_.begin(), moves_.end(), [&](const auto& one) {
            return one.second == step && one.first == Move{from, to};
        });
    }
    /// From which step on a tile is allowed for good.
    std::uint32_t free_from(Cell cell) const {
        std::uint32_t from = 0;
        for (const Timed& one : tiles_)
            if (one.cell == cell) from = std::max(from, one.step + 1);
        return from;
    }
    std::uint32_t last() const { return last_; } ///< the first step from which on nothing is forbidden

private:
    std::unordered_set<Timed> tiles_;
    std::vector<std::pair<Move, std::uint32_t>> moves_;
    std::uint32_t last_ = 0;
};

namespace detail {
/// What a step costs and, among steps of one cost, how many others it meets: in one number, the cost in front.
struct MeetingWeights {
    using key_type = TimedEdge;
    using value_type = std::uint64_t;
    using reference = std::uint64_t;
    using category = boost::readable_property_map_tag;
    static constexpr std::uint64_t one = std::uint64_t(1) << 16; ///< of the costs
    const std::vector<const std::vector<Cell>*>* others;         ///< plans
    friend std::uint64_t get(const MeetingWeights& map, const TimedEdge& e) {
        const Move move{e.from.cell, e.to.cell};
        std::uint64_t met = 0;
        for (const auto* plan : *map.others) {
            const Move other{at_step(*plan, e.from.step), at_step(*plan, e.from.step + 1)};
            met += meet(move, other) || move.to == other.to;
        }
        return one * (e.diagonal ? Tile<std::uint32_t>::diagonal : Tile<std::uint32_t>::straight) + met;
    }
};
} // namespace detail

/// \tparam Map a Grid on even ground
template <class Map> class ConflictBased {
public:
    /// \param map read, never copied: it must live as long as this
    explicit ConflictBased(const Map& map) : map_(&map) {
        static_assert(
            std::is_same_v<typename Map::ground, Even>,
            "Ansatz paths: ConflictBased plans in steps of one length; it needs even ground, Grid<Eight<>, Even>");
    }
    explicit ConflictBased(const Map&&) = delete; // a map that is gone after this line

    /// Plans for all; what they cost together is the least there is. A step costs as on the grid, waiting as a straight
    /// one, and an agent that has come to its goal for good costs nothing more.
    /// \param most how many nodes of the tree may be expanded before it gives up
    /// \return found, gave_up, or no_path where it is known that there is none
    /// \throws std::invalid_argument for no errand, for a tile outside the map, and for two who begin or end in one tile
    Outcome find(std::span<const Errand> errands, std::size_t most = 10000) {
        detail::require_errands("ConflictBased::find", *map_, errands);
        errands_.assign(errands.begin(), errands.end());
        plans_.clear();
        tree_.clear(), open_.clear();
        looked_at_ = expanded_ = 0;
        outcome_ = begin() ? grow(most) : Outcome::no_path;
        if (outcome_ != Outcome::found) plans_.assign(errands.size(), {});
        tree_.clear(), open_.clear();
        return outcome_;
    }
    /// Where an agent is in each step, from the first; behind the last it stays where it is. Empty where none was
    /// found.
    /// \throws std::invalid_argument for an agent that was not among the errands
    const std::vector<Cell>& plan(std::size_t agent) const {
        if (agent >= plans_.size())
            refuse_value("ConflictBased::plan", "agent", std::to_string(agent),
                         "the last search had " + std::to_string(plans_.size()) + " agents, counted from 0");
        return plans_[agent];
    }
    /// Where an agent is in a step.
    /// \throws std::invalid_argument for an agent that was not among the errands, or where no plan was found
    Cell at(std::size_t agent, std::size_t step) const {
        const auto& cells = plan(agent);
        if (cells.empty()) refuse_value("ConflictBased::at", "the outcome", std::string(name_of(outcome_)), why());
        return at_step(cells, step);
    }
    Outcome outcome() const { return outcome_; } ///< of the last search
    /// What all plans cost together, 33461 a straight step and 47321 a diagonal one; 0 where none was found.
    std::uint64_t cost() const {
        std::uint64_t sum = 0;
        for (const auto& plan : plans_) sum += cost_of(plan);
        return sum;
    }
    double tiles() const { return double(cost()) / Tile<std::uint32_t>::straight; } ///< the same in tiles
    std::size_t steps() const {                                                     ///< until all stand
        std::size_t most = 0;
        for (const auto& plan : plans_) most = std::max(most, plan.size());
        return most == 0 ? 0 : most - 1;
    }
    std::size_t tree() const { return looked_at_; }    ///< nodes of the tree that were expanded
    std::size_t expanded() const { return expanded_; } ///< nodes expanded in space and time, in all searches
    /// In a sentence, what came of it.
    std::string why() const {
        switch (outcome_) {
        case Outcome::not_begun: return "nothing was searched yet";
        case Outcome::found: return "there is a plan for all " + std::to_string(plans_.size()) + " agents";
        case Outcome::no_path: return "there is no plan for all " + std::to_string(plans_.size()) + " agents";
        default:
            return "after " + std::to_string(looked_at_) +
                   " nodes of the tree there was no plan without a meeting; there may be none";
        }
    }

private:
    static constexpr std::uint32_t root = 0xffffffff;
    /// A node of the tree: what is forbidden to one agent beside what its parents forbid, and its plan.
    struct Branch {
        std::uint32_t parent;
        std::uint32_t agent;
        std::uint32_t step;
        bool tile; ///< it must not be where the move begins, else not make the move
        Move move;
        std::vector<Cell> plan;
        std::uint64_t cost; ///< of all
        std::size_t meetings;
    };
    /// Cheapest first, then with the fewest meetings, then the newest.
    auto later() const {
        return [this](std::uint32_t a, std::uint32_t b) {
            const auto rank = [this](std::uint32_t i) {
                return std::tuple(tree_[i].cost, tree_[i].meetings, root - i);
            };
            return rank(a) > rank(b);
        };
    }
    static std::uint64_t cost_of(const std::vector<Cell>& plan) {
        std::uint64_t sum = 0;
        for (std::size_t s = 1; s < plan.size(); ++s)
            sum += plan[s].x != plan[s - 1].x && plan[s].y != plan[s - 1].y ? Tile<std::uint32_t>::diagonal
                                                                            : Tile<std::uint32_t>::straight;
        return sum;
    }
    std::size_t meetings() const {
        std::size_t pairs = 0;
        for (std::size_t i = 0; i < plans_.size(); ++i)
            for (std::size_t k = 0; k < i; ++k) pairs += detail::first_meeting(plans_[i], plans_[k], i, k).has_value();
        return pairs;
    }
    /// Plans each agent alone. \return whether each has a path
    bool begin() {
        fields_.resize(errands_.size(), FlowField<Map>(*map_));
        forbidden_.clear();
        Branch first{root, root, 0, false, {}, {}, 0, 0};
        for (std::size_t i = 0; i < errands_.size(); ++i) {
            if (fields_[i].aim(errands_[i].goal) != Outcome::found || !fields_[i].reaches(errands_[i].start)) {
                plans_.assign(errands_.size(), {});
                return false;
            }
            plans_.push_back(plan_for(i));
            first.cost += cost_of(plans_.back());
        }
        first_ = plans_;
        first.meetings = meetings();
        tree_.push_back(std::move(first));
        open_.push_back(0);
        return true;
    }
    Outcome grow(std::size_t most) {
        while (!open_.empty()) {
            if (looked_at_ == most) return Outcome::gave_up;
            std::pop_heap(open_.begin(), open_.end(), later());
            const std::uint32_t node = open_.back();
            open_.pop_back();
            ++looked_at_;
            restore(node);
            const auto meeting = first_meeting(plans_);
            if (!meeting) return Outcome::found;
            const bool tile = meeting->kind == Meeting::Kind::in_a_tile;
            for (const auto& [agent, move] :
                 {std::pair(meeting->first, meeting->one), std::pair(meeting->second, meeting->other)})
                branch(node, std::uint32_t(agent), move, meeting->step, tile);
        }
        return Outcome::no_path;
    }
    /// The plans of a node.
    void restore(std::uint32_t node) {
        std::vector<std::uint8_t> known(plans_.size());
        for (auto at = node; at != root; at = tree_[at].parent) {
            const auto agent = tree_[at].agent;
            if (agent == root || known[agent]) continue;
            known[agent] = 1;
            plans_[agent] = tree_[at].plan;
        }
        for (std::size_t i = 0; i < plans_.size(); ++i)
            if (!known[i]) plans_[i] = first_[i];
    }
    /// One of two has to give way.
    void branch(std::uint32_t node, std::uint32_t agent, const Move& move, std::uint32_t step, bool tile) {
        if (tile && step == 0) return; // where it begins
        forbidden_.clear();
        const auto add = [&](bool is_tile, const Move& what, std::uint32_t when) {
            if (is_tile) forbidden_.forbid(what.from, when);
            else forbidden_.forbid(what, when);
        };
        add(tile, move, step);
        for (auto at = node; at != root; at = tree_[at].parent)
            if (tree_[at].agent == agent) add(tree_[at].tile, tree_[at].move, tree_[at].step);
        auto plan = plan_for(agent);
        if (plan.empty()) return;
        std::swap(plan, plans_[agent]);
        Branch next{node, agent, step, tile, move, plans_[agent], 0, meetings()};
        next.cost = tree_[node].cost - cost_of(plan) + cost_of(plans_[agent]);
        std::swap(plan, plans_[agent]);
        tree_.push_back(std::move(next));
        open_.push_back(std::uint32_t(tree_.size() - 1));
        std::push_heap(open_.begin(), open_.end(), later());
    }
    /// The cheapest plan of an agent that keeps to what is allowed; of several, one that meets the fewest others.
    std::vector<Cell> plan_for(std::size_t agent) {
        others_.clear();
        std::size_t until = 0;
        for (std::size_t i = 0; i < plans_.size(); ++i)
            if (i != agent) others_.push_back(&plans_[i]), until = std::max(until, plans_[i].size());
        const TimedGrid graph(*map_, forbidden_, std::uint32_t(until));
        const Errand& errand = errands_[agent];
        const auto& field = fields_[agent];
        const auto there = [goal = errand.goal, from = forbidden_.free_from(errand.goal)](const Timed& v) {
            return v.cell == goal && v.step >= from;
        };
        const auto left = [&field](const Timed& v) -> std::uint64_t {
            return field.reaches(v.cell) ? detail::MeetingWeights::one * field.cost(v.cell) : ~std::uint64_t(0);
        };
        AStar search{graph, GoalWhere{there}, By{left}, CostIn<std::uint64_t>{},
                     WeightsOf{detail::MeetingWeights{&others_}}};
        std::vector<Cell> plan;
        if (search.find(Timed{errand.start, 0}) == Outcome::found)
            for (const Timed& v : search.path()) plan.push_back(v.cell);
        expanded_ += search.expanded();
        return plan;
    }

    const Map* map_;
    std::vector<Errand> errands_;
    std::vector<FlowField<Map>> fields_;   ///< to the goal of each
    std::vector<std::vector<Cell>> plans_; ///< of the node that is expanded
    std::vector<std::vector<Cell>> first_; ///< of the root
    std::vector<Branch> tree_;
    std::vector<std::uint32_t> open_; ///< a heap of places in the tree
    std::vector<const std::vector<Cell>*> others_;
    Forbidden forbidden_;
    std::size_t looked_at_ = 0, expanded_ = 0;
    Outcome outcome_ = Outcome::not_begun;
};
/// `ConflictBased{map}`.
template <class Map> ConflictBased(const Map&) -> ConflictBased<Map>;

} // namespace ansatz::paths
