// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Reservations`, which tile belongs to which agent in which step, and `TimedGrid`, a grid in space and time around
/// them: what `Prioritised` searches (notes 6.3: A* is a method for a single agent).
///
/// A vertex is a tile and a step; all steps from that in which the last one rests are one, since nothing changes any
/// more. Its edges lead to the next step: to a neighbour, or to the same tile, which is waiting. Left out are those
/// that would meet what is reserved: a tile that is taken then, two who change places, and two whose diagonal steps
/// cross. No edge is stored.

#include <ansatz/paths/graph.hpp>
#include <ansatz/paths/grid/graph.hpp>
#include <ansatz/paths/grid/grid.hpp>
#include <ansatz/paths/implicit_graph.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <limits>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace ansatz::paths {

/// A tile at a step of the clock that all share.
struct Timed {
    Cell cell;              ///< where
    std::uint32_t step = 0; ///< when
    friend bool operator==(const Timed& a, const Timed& b) { return a.cell == b.cell && a.step == b.step; }
};
/// "(3, 4) in step 7".
[[gnu::cold]] inline std::string name_of(const Timed& v) {
    return name_of(v.cell) + " in step " + std::to_string(v.step);
}

} // namespace ansatz::paths

template <> struct std::hash<ansatz::paths::Timed> {
    std::size_t operator()(const ansatz::paths::Timed& v) const noexcept {
        return (std::hash<ansatz::paths::Cell>{}(v.cell) ^ (std::size_t(v.step) << 32)) * 0x9e3779b97f4a7c15u;
    }
};

namespace ansatz::paths {

/// Which agent is where, and when.
class Reservations {
public:
    static constexpr std::uint32_t nobody = 0xffffffff;   ///< no agent
    static constexpr std::uint32_t for_ever = 0xffffffff; ///< no step

    /// Forgets all.
    void clear() { taken_.clear(), rests_.clear(), last_ = 0; }
    /// Which agent has a tile in a step.
    std::uint32_t owner(Cell cell, std::uint32_t step) const {
        if (const auto at = rests_.find(cell); at != rests_.end() && step >= at->second.step) return at->second.agent;
        const auto at = taken_.find({cell, step});
        return at == taken_.end() ? nobody : at->second;
    }
    /// Whether a step from one tile to a neighbour, or waiting, meets no other; `step` is when it begins.
    bool is_free(Cell from, Cell to, std::uint32_t step) const {
        if (owner(to, step + 1) != nobody) return false;
        if (from == to) return true;
        const auto there = owner(to, step);
        if (there != nobody && owner(from, step + 1) == there) return false; // they would change places
        if (from.x == to.x || from.y == to.y) return true;
        const Cell a{to.x, from.y}, b{from.x, to.y}; // the other diagonal
        const auto at_a = owner(a, step), at_b = owner(b, step);
        return !(at_a != nobody && owner(b, step + 1) == at_a) && !(at_b != nobody && owner(a, step + 1) == at_b);
    }
    /// From which step on no other agent comes to a tile; `for_ever` where one rests.
    std::uint32_t free_from(Cell cell) const {
        if (rests_.find(cell) != rests_.end()) return for_ever;
        std::uint32_t from = 0;
        for (std::uint32_t s = 0; s <= last_; ++s)
            if (taken_.find({cell, s}) != taken_.end()) from = s + 1;
        return from;
    }
    std::uint32_t last() const { return last_; } ///< the step in which the last one comes to rest

    /// Takes a plan: its k-th tile in step k, and the last one for ever.
    /// \throws std::invalid_argument for one that meets what is reserved; nothing is taken
    void take(std::uint32_t agent, std::span<const Cell> plan) {
        if (plan.empty()) refuse_value("Reservations::take", "the plan", "empty", "it holds where the agent begins");
        if (owner(plan.front(), 0) != nobody) refuse_taken(plan.front(), 0);
        for (std::uint32_t s = 0; s + 1 < plan.size(); ++s)
            if (!is_free(plan[s], plan[s + 1], s)) refuse_taken(plan[s + 1], s + 1);
        const auto end = std::uint32_t(plan.size() - 1);
        if (const auto from = free_from(plan.back()); from > end)
            refuse_taken(plan.back(), from == for_ever ? end : from - 1);
        for (std::uint32_t s = 0; s < end; ++s) taken_[{plan[s], s}] = agent;
        rests_[plan.back()] = {agent, end};
        last_ = std::max(last_, end);
    }

private:
    [[noreturn, gnu::cold]] void refuse_taken(Cell cell, std::uint32_t step) const {
        const auto who = owner(cell, step);
        refuse_value("Reservations::take", "the tile " + name_of(Timed{cell, step}),
                     who == nobody ? std::string("on the way of another") : "reserved for agent " + std::to_string(who),
                     "a plan keeps to what is free");
    }
    struct Rest {
        std::uint32_t agent, step;
    };
    std::unordered_map<Timed, std::uint32_t> taken_;
    std::unordered_map<Cell, Rest> rests_;
    std::uint32_t last_ = 0;
};

/// A step of an agent: to a neighbour, or none.
struct TimedEdge {
    Timed from;            ///< where, and when it begins
    Timed to;              ///< one step later
    bool diagonal = false; ///< both coordinates change
    friend bool operator==(const TimedEdge& a, const TimedEdge& b) { return a.from == b.from && a.to == b.to; }
};

/// A grid in space and time.
/// \tparam Table what is taken: `is_free(from, to, step)` and `last()`, as `Reservations` have them
template <class Map, class Table = Reservations> class TimedGrid {
public:
    using default_cost = std::uint32_t; ///< as on a grid
    /// \param map          read, never copied
    /// \param reservations read, never copied
    /// \param until        up to here steps are told apart, though nothing may be reserved there
    TimedGrid(const Map& map, const Table& reservations, std::uint32_t until = 0)
        : map_(&map), reservations_(&reservations), settled_(std::max(until, reservations.last())) {}
    const Map& map() const { return *map_; }                     ///< in space
    const Table& reservations() const { return *reservations_; } ///< in time
    /// The first step from which on nothing changes.
    std::uint32_t settled() const { return settled_; }

private:
    const Map* map_;
    const Table* reservations_;
    std::uint32_t settled_;
};
/// `TimedGrid{map, reservations}`.
template <class Map, class Table> TimedGrid(const Map&, const Table&) -> TimedGrid<Map, Table>;
/// With steps that are told apart up to one.
template <class Map, class Table> TimedGrid(const Map&, const Table&, std::uint32_t) -> TimedGrid<Map, Table>;

/// The steps that are free, one after the other; waiting is the last.
template <class Map, class Table = Reservations> class TimedEdges {
public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = TimedEdge;
    using difference_type = std::ptrdiff_t;
    using pointer = const value_type*;
    using reference = value_type;
    TimedEdges() = default;
    /// At the first free step in direction `d` or behind it; 8 is waiting, 9 the end.
    TimedEdges(const TimedGrid<Map, Table>& graph, const Timed& from, int d) : graph_(&graph), from_(from), d_(d) {
        skip();
    }
    /// What it points to.
    value_type operator*() const {
        return {from_, {target(), std::min(from_.step + 1, graph_->settled())}, d_ >= 4 && d_ < 8};
    }
    TimedEdges& operator++() {
        ++d_;
        skip();
        return *this;
    }
    TimedEdges operator++(int) {
        auto old = *this;
        ++*this;
        return old;
    }
    friend bool operator==(const TimedEdges& a, const TimedEdges& b) { return a.d_ == b.d_; }

private:
    Cell target() const { return d_ < 8 ? detail::step(from_.cell, unsigned(d_)) : from_.cell; }
    bool open() const {
        if (d_ == 8) return from_.step < graph_->settled(); // behind that, waiting gains nothing
        return (graph_->map().open_directions(from_.cell) >> d_ & 1) != 0;
    }
    void skip() {
        while (d_ < 9 && !(open() && graph_->reservations().is_free(from_.cell, target(), from_.step))) ++d_;
    }
    const TimedGrid<Map, Table>* graph_ = nullptr;
    Timed from_;
    int d_ = 9;
};

/// What a step costs, as a property map: as on the grid, and waiting as a straight one.
template <class Cost> struct TimedWeights {
    using key_type = TimedEdge;
    using value_type = Cost;
    using reference = Cost;
    using category = boost::readable_property_map_tag;
    friend Cost get(const TimedWeights&, const TimedEdge& e) {
        return e.diagonal ? Tile<Cost>::diagonal : Tile<Cost>::straight;
    }
};

/// The steps that are free, waiting among them.
template <class M, class T>
std::pair<TimedEdges<M, T>, TimedEdges<M, T>> out_edges(const Timed& v, const TimedGrid<M, T>& g) {
    return {TimedEdges<M, T>(g, v, 0), TimedEdges<M, T>(g, v, 9)};
}
template <class M, class T> std::size_t out_degree(const Timed& v, const TimedGrid<M, T>& g) {
    const auto edges = out_edges(v, g);
    return std::size_t(std::distance(edges.first, edges.second));
}
template <class M, class T> Timed source(const TimedEdge& e, const TimedGrid<M, T>&) { return e.from; }
template <class M, class T> Timed target(const TimedEdge& e, const TimedGrid<M, T>&) { return e.to; }
template <class M, class T> TimedWeights<double> get(boost::edge_weight_t, const TimedGrid<M, T>&) { return {}; }
/// What steps cost in the number of a search.
template <class M, class T, class Cost>
TimedWeights<Cost> edge_weights(const TimedGrid<M, T>&, std::type_identity<Cost>) {
    return {};
}
template <class M, class T> bool has_vertex(const Timed& v, const TimedGrid<M, T>& g) {
    return g.map().contains(v.cell);
}
template <class M, class T> bool is_blocked(const Timed& v, const TimedGrid<M, T>& g) {
    return !g.map().passable(v.cell);
}
template <class M, class T> std::string name_of(const Timed& v, const TimedGrid<M, T>&) { return name_of(v); }

} // namespace ansatz::paths

namespace boost {
template <class M, class T>
struct graph_traits<ansatz::paths::TimedGrid<M, T>>
    : ansatz::paths::ImplicitGraphTraits<ansatz::paths::Timed, ansatz::paths::TimedEdge,
                                         ansatz::paths::TimedEdges<M, T>, disallow_parallel_edge_tag> {};
template <class M, class T> struct property_map<ansatz::paths::TimedGrid<M, T>, edge_weight_t> {
    using type = ansatz::paths::TimedWeights<double>;
    using const_type = type;
};
} // namespace boost
