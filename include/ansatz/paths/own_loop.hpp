// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `OwnLoop`: the loop of A* as the notes write it (6.1), over Boost.Graph's concepts; the default engine.
///
/// It asks the graph for nothing but out_edges and target, visits no vertex that the search does not come to, stops
/// without an exception, can be left after any number of expansions and taken up again, and allocates nothing once its
/// arrays have grown. The numbers in its comments are the notes' steps.

#include <ansatz/paths/graph.hpp>
#include <ansatz/paths/nodes.hpp>
#include <ansatz/paths/outcome.hpp>
#include <ansatz/paths/roles.hpp>
#include <ansatz/paths/successors.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace ansatz::paths {

/// The library's own loop.
struct OwnLoop {
    using role = roles::Engine;
    static constexpr bool resumable = true;      ///< can be left and taken up again
    static constexpr bool several_starts = true; ///< takes all that are on the open list

    /// Expands up to `most` nodes.
    /// \param work what the search knows: graph, weights, nodes, queue, estimate, counters
    template <class Work, class Watcher>
    [[gnu::noinline]] static Outcome run(Work& work, std::size_t most,
                                         Watcher& watcher) { // on its own, so that registers suffice
        using Vertex = typename Work::Vertex;
        using Cost = typename Work::Cost;
        constexpr bool exact = Work::Queue::exact;
        // Values, not references: behind a reference the compiler would read them again after each node that is
        // written.
        const auto estimate = work.bound();
        const auto weights = work.weights();
        const auto place = work.place();
        const auto goal = work.goal;
        const std::uint32_t open = work.nodes.stamps().open();
        auto nearest_h = work.nearest_h;
        Counts counts;
        auto end = [&](Outcome outcome) {
            work.nearest_h = nearest_h;
            work.expanded += counts.expanded, work.generated += counts.generated, work.reopened += counts.reopened;
            return outcome;
        };
        while (!work.queue.empty()) { // 2: for each node P on the open list
            if constexpr (!exact)
                if (work.goal_known && !(work.queue.least_f() < work.goal_cost)) return end(Outcome::found);
            if (counts.expanded == most) return end(Outcome::running);
            const Vertex p = work.queue.pop();
            if (const Vertex* next = work.queue.peek()) place.fetch_around(*next, work.graph());
            auto& node = place.of(p);
            if (node.stamp != open) continue; // an old entry of a node whose f fell later
            if constexpr (!exact)
                if (work.goal_known && !(node.f() < work.goal_cost)) continue;
            node.stamp = open + 1; // 2.1: to the closed list
            watcher.closed(p, node);
            const Cost p_g = node.g;
            if (node.h < nearest_h) nearest_h = node.h, work.nearest = p;
            if (Work::reaches(p, goal)) { // 2.2: the end node
                work.reach(p, p_g);
                watcher.reached(p, node);
                if constexpr (exact) return end(Outcome::found);
                continue; // what is in the queue may still be cheaper, by less than a bucket
            }
            ++counts.expanded;
            if constexpr (!std::is_same_v<typename Work::Successors, EveryEdge>) {
                leap(work, place, p, Vertex(node.parent), p_g, estimate, open, counts, watcher);
                continue;
            }
            const auto& graph = work.graph();
            const auto edges = out_edges(p, graph);
            for (auto at = edges.first; at != edges.second; ++at) { // 2.3: for each node Q connected to P
                const auto edge = *at;
                const Vertex q = target(edge, graph);
                if (!detail::edge_passable(edge, graph) || !detail::vertex_passable(q, graph)) { // 2.3.1
                    watcher.skipped(p, q);
                    continue;
                }
                const auto weight = get(weights, edge);
                if constexpr (!std::is_unsigned_v<std::decay_t<decltype(weight)>>)
                    if (!(weight >= 0)) return work.refuse_weight(p, q, weight), end(work.trouble);
                relax(work, place.of_target(edge, q), p, q, p_g, Work::cost_of(weight), estimate, open, counts,
                      watcher);
            }
        }
        return end(work.goal_known ? Outcome::found : work.too_far ? Outcome::too_far : Outcome::no_path);
    }

private:
    struct Counts {
        std::size_t expanded = 0, generated = 0, reopened = 0;
    };
    /// Where a run ends, and the start and the goal that the engine was told.
    template <class Work> struct Reaches {
        typename Work::Vertex start;
        std::conditional_t<std::is_same_v<typename Work::Goal, typename Work::Vertex>, typename Work::Goal,
                           const typename Work::Goal&>
            goal;
        bool operator()(const typename Work::Vertex& v) const { return Work::reaches(v, goal); }
    };
    /// 2.3 where successors may be more than one edge away.
    template <class Work, class Place, class Vertex, class Cost, class Estimate, class Watcher>
    static void leap(Work& work, const Place& place, const Vertex& p, const Vertex& parent, const Cost p_g,
                     const Estimate& estimate, const std::uint32_t open, Counts& counts, Watcher& watcher) {
        Work::Successors::each(work.graph(), p, parent, Reaches<Work>{work.start, work.goal},
                               [&](const Vertex& q, const auto& edge, std::size_t edges) {
                                   const Cost step = detail::times(edges, Work::cost_of(get(work.weights(), edge)));
                                   relax(work, place.of_target(edge, q), p, q, p_g, step, estimate, open, counts,
                                         watcher);
                               });
    }
    /// 2.3.2 to 2.3.4: to P it costs p_g, and from there to Q `step` more.
    template <class Work, class Node, class Vertex, class Cost, class Estimate, class Watcher>
    [[gnu::always_inline]] static void relax(Work& work, Node& node, const Vertex& p, const Vertex& q, const Cost p_g,
                                             const Cost step, const Estimate& estimate, const std::uint32_t open,
                                             Counts& counts, Watcher& watcher) {
        const bool first = node.stamp < open; // on no list
        const Cost g = detail::add_unchecked(p_g, step);
        if (!first && !(g < node.g)) return;
        if (detail::is_too_dear(p_g, step, g)) { // asked of few; an infinite weight is no way
            work.too_far = work.too_far || (first && std::integral<Cost>);
            return;
        }
        if (first) {
            node.h = typename Work::Guess(estimate(q));
            ++counts.generated;
        } else if (node.stamp != open) {
            if constexpr (!Work::Reopens::updates) return;
            ++counts.reopened;
        }
        const bool closed = !first && node.stamp != open;
        node.g = g, node.parent = p;
        if (!closed || Work::Reopens::reopens) {
            node.stamp = open;
            work.queue.push(node.f(), node.h, q);
        }
        if (first) watcher.opened(q, node);
        else if (closed) watcher.reopened(q, node);
        else watcher.improved(q, node);
    }
};

} // namespace ansatz::paths
