// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `BoostAStar`: boost::astar_search itself as the engine, to compare with: `AStar{graph, Octile{}, BoostAStar{}}`.
///
/// It prepares every vertex of the graph for each query, allocates, stops by an exception (which is caught in here),
/// cannot be left and taken up again, and has its own queue and its own rule for closed nodes (it reopens). On an
/// undirectedS graph with an inconsistent heuristic it answers with wrong costs: no reference there. A search with it
/// expands its budget, or all, in one go.

#include <ansatz/paths/graph.hpp>
#include <ansatz/paths/outcome.hpp>
#include <ansatz/paths/roles.hpp>
#include <ansatz/paths/successors.hpp>

#include <boost/graph/astar_search.hpp>
#include <boost/property_map/property_map.hpp>

#include <concepts>
#include <cstddef>
#include <functional>
#include <type_traits>
#include <vector>

namespace ansatz::paths {

namespace detail {

/// The search's weights with blocked edges at infinity, as boost::astar_search knows no flags.
template <class Work> struct BoostWeights {
    using key_type = EdgeOf<typename Work::Graph>;
    using value_type = typename Work::Cost;
    using reference = value_type;
    using category = boost::readable_property_map_tag;
    const Work* work;
    friend value_type get(const BoostWeights& map, const key_type& e) {
        const auto& g = map.work->graph();
        if (!edge_passable(e, g) || !vertex_passable(typename Work::Vertex(target(e, g)), g))
            return infinite<value_type>;
        const auto weight = get(map.work->weights(), e);
        return weight >= decltype(weight)(0) ? Work::cost_of(weight)
                                             : value_type(0); // the visitor refuses it, before Boost throws
    }
};
template <class Work> struct BoostIndex {
    using key_type = typename Work::Vertex;
    using value_type = std::size_t;
    using reference = value_type;
    using category = boost::readable_property_map_tag;
    Work* work;
    friend value_type get(const BoostIndex& map, const key_type& v) { return map.work->slot(v); }
};

struct BoostStop {};

template <class Work, class Distances> struct BoostVisitor : boost::default_astar_visitor {
    Work* work;
    Distances distances;
    std::size_t most;
    template <class V, class Graph> void examine_vertex(const V& v, const Graph&) {
        if (!(get(distances, v) < infinite<typename Work::Cost>))
            throw BoostStop{}; // only what cannot be reached is left
        if (work->is_goal(v)) {
            work->reach(v, get(distances, v));
            throw BoostStop{};
        }
        if (work->expanded == most) throw BoostStop{};
        ++work->expanded;
    }
    template <class V, class Graph> void discover_vertex(const V&, const Graph&) { ++work->generated; }
    template <class E, class Graph> void black_target(const E&, const Graph&) { ++work->reopened; }
    template <class E, class Graph> void examine_edge(const E& e, const Graph& g) {
        const auto weight = get(work->weights(), e);
        if constexpr (!std::is_unsigned_v<std::decay_t<decltype(weight)>>)
            if (!(weight >= 0)) {
                work->refuse_weight(source(e, g), target(e, g), weight);
                work->too_far = false;
                throw BoostStop{};
            }
        if constexpr (std::integral<typename Work::Cost>)
            if (edge_passable(e, g) && vertex_passable(typename Work::Vertex(target(e, g)), g) &&
                !(add(get(distances, source(e, g)), Work::cost_of(weight)) < infinite<typename Work::Cost>))
                work->too_far = true;
    }
};

} // namespace detail

/// Boost.Graph's own A*.
struct BoostAStar {
    using role = roles::Engine;
    static constexpr bool resumable = false;      ///< goes on to its end
    static constexpr bool several_starts = false; ///< knows one

    /// Searches to the end, or as far as so many expansions lead.
    template <class Work, class Watcher> static Outcome run(Work& work, std::size_t most, Watcher& watcher) {
        using Vertex = typename Work::Vertex;
        using Cost = typename Work::Cost;
        static_assert(std::is_same_v<typename Work::Successors, EveryEdge>,
                      "Ansatz paths: BoostAStar visits every edge; with JumpPoints take OwnLoop, the default engine");
        static_assert(Work::numbered, "Ansatz paths: BoostAStar needs a graph whose vertices are numbered and listed");
        const detail::BoostIndex<Work> index{&work};
        const std::size_t n = work.count();
        std::vector<Vertex> parents(n);
        std::vector<Cost> g(n);
        std::vector<typename Work::Guess> f(n);
        std::vector<boost::default_color_type> colours(n);
        const auto g_map = boost::make_iterator_property_map(g.begin(), index);
        const auto f_map = boost::make_iterator_property_map(f.begin(), index);
        const auto parent_map = boost::make_iterator_property_map(parents.begin(), index);
        const auto colour_map = boost::make_iterator_property_map(colours.begin(), index);
        detail::BoostVisitor<Work, std::decay_t<decltype(g_map)>> visitor{{}, &work, g_map, most};
        work.generated = 0;
        work.trouble = Outcome::running;
        try {
            boost::astar_search(
                work.graph(), work.start, [&](const Vertex& v) { return work.estimate(v); }, visitor, parent_map, f_map,
                g_map, detail::BoostWeights<Work>{&work}, index, colour_map, std::less<>{},
                [](Cost a, auto b) { return detail::add(decltype(b)(a), b); }, detail::infinite<Cost>, Cost(0));
        } catch (const detail::BoostStop&) { // its documented way to stop early
        }
        if (work.trouble == Outcome::bad_weight) return work.trouble;
        keep(work, parents, g, colours, watcher);
        if (work.goal_known) return Outcome::found;
        if (work.expanded == most) return Outcome::running;
        return work.too_far ? Outcome::too_far : Outcome::no_path;
    }

private:
    /// Writes what it found into the search's own nodes, so that the lists and values can be read.
    template <class Work, class Parents, class Costs, class Colours, class Watcher>
    static void keep(Work& work, const Parents& parents, const Costs& g, const Colours& colours, Watcher&) {
        work.each_vertex([&](const typename Work::Vertex& v) {
            const std::size_t i = work.slot(v);
            if (colours[i] == boost::white_color || !(g[i] < detail::infinite<typename Work::Cost>)) return;
            auto& node = work.nodes[i];
            node.g = g[i], node.h = work.estimate(v), node.parent = parents[i];
            const bool closed = colours[i] == boost::black_color || (work.goal_known && v == work.goal_vertex);
            node.stamp = closed ? work.nodes.stamps().closed() : work.nodes.stamps().open();
            if (closed && node.h < work.nearest_h) work.nearest_h = node.h, work.nearest = v;
        });
    }
};

} // namespace ansatz::paths
