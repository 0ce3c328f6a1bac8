// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `LazyTheta`: an engine of AStar that finds paths of any angle on a grid (beyond the notes' 6.1).
///
/// A grid's path turns by 45 degrees. Theta* (Nash, Daniel, Koenig and Felner 2007) lets the parent of a node be any
/// tile from which one can walk to it in a straight line, so that the path goes from corner to corner; its lazy form
/// (Nash, Koenig and Tovey 2010), which this is, takes for granted that a node can be seen from the parent of its
/// neighbour, and checks only when the node is closed: one line of sight a node instead of eight.
///
/// Take it where walkers go in straight lines and paths shall be short. It is slower than A*
/// <!-- costs: paths any angle/*: LazyTheta > 2 "along the tiles" -->, and its path, though
/// mostly shorter than A*'s with the zigzag taken out (`smooth`), is not always, and not the shortest there is.
/// `AnyAngle` does both and keeps the better one. It knows even ground only.

#include <ansatz/paths/grid/grid.hpp>
#include <ansatz/paths/heuristics/euclid.hpp>
#include <ansatz/paths/outcome.hpp>
#include <ansatz/paths/roles.hpp>
#include <ansatz/paths/smoothing.hpp>
#include <ansatz/paths/successors.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace ansatz::paths {

/// Paths of any angle: `AStar{map, LazyTheta{}}`. Its path holds the corners, not all the tiles between them, and costs
/// count in tiles. Unless others are given, `Euclid` and `CostIn<double>` come with it. Closed nodes stay closed,
/// whatever Reopening says: their parents were checked.
struct LazyTheta {
    using role = roles::Engine;
    static constexpr bool resumable = true;      ///< can be left and taken up again
    static constexpr bool several_starts = true; ///< takes all that are on the open list
    using default_heuristic = Euclid;            ///< Octile is too much for one who walks straight
    using default_cost = double;                 ///< for lengths of any angle
    /// Whether a heuristic may be no overestimate.
    template <class Heuristic>
    static constexpr bool admits = !std::is_same_v<Heuristic, Octile> && !std::is_same_v<Heuristic, Manhattan>;

    /// Expands up to `most` nodes.
    template <class Work, class Watcher>
    [[gnu::noinline]] static Outcome run(Work& work, std::size_t most, Watcher& watcher) {
        static_assert(Checked<Work>::ok);
        const auto place = work.place();
        const std::uint32_t open = work.nodes.stamps().open();
        for (std::size_t expanded = 0; !work.queue.empty();) {
            if (expanded == most) return Outcome::running;
            const Cell p = work.queue.pop();
            auto& node = place.of(p);
            if (node.stamp != open) continue; // an old entry of a node whose f fell later
            if (!(node.parent == p) && !line_of_sight(work.graph(), node.parent, p)) look_again(work, place, p, node);
            node.stamp = open + 1;
            watcher.closed(p, node);
            if (node.h < work.nearest_h) work.nearest_h = node.h, work.nearest = p;
            if (Work::reaches(p, work.goal)) {
                work.reach(p, node.g);
                watcher.reached(p, node);
                return Outcome::found;
            }
            ++expanded, ++work.expanded;
            expand(work, place, p, node, open, watcher);
        }
        return Outcome::no_path;
    }

private:
    /// A class and no function: its sentences come before what the compiler finds wrong in the loop.
    template <class Work> struct Checked {
        static constexpr bool even = requires { requires std::is_same_v<typename Work::Graph::ground, Even>; };
        static_assert(even,
                      "Ansatz paths: LazyTheta walks straight over the tiles of a grid on even ground, Grid<Eight<>, "
                      "Even>; elsewhere take OwnLoop, the default engine, and smooth()");
        static_assert(std::is_floating_point_v<typename Work::Cost>,
                      "Ansatz paths: LazyTheta counts lengths of any angle, which whole numbers would cut off; leave "
                      "CostIn out, or take CostIn<double>");
        static constexpr bool own_weights =
            std::is_same_v<typename Work::Weights, GridWeights<typename Work::Cost, Even>>;
        static_assert(!even || own_weights, "Ansatz paths: LazyTheta counts lengths and cannot have WeightsOf");
        static_assert(Work::Queue::exact && std::is_same_v<typename Work::Successors, EveryEdge>,
                      "Ansatz paths: LazyTheta visits every edge in the order of f; leave Buckets and JumpPoints out");
        static constexpr bool ok = true;
    };
    template <class Cost> static Cost tiles(Cell a, Cell b) {
        const double dx = double(a.x) - b.x, dy = double(a.y) - b.y;
        return Cost(std::sqrt(dx * dx + dy * dy));
    }
    /// The parent that was taken for granted does not see the node: the best that does of its closed neighbours and
    /// their parents.
    template <class Work, class Place, class Node>
    static void look_again(Work& work, const Place& place, Cell p, Node& node) {
        using Cost = typename Work::Cost;
        const auto& map = work.graph();
        const std::uint32_t closed = work.nodes.stamps().closed();
        const Cell refused = node.parent;
        node.g = detail::infinite<Cost>;
        const auto each_closed = [&](auto&& use) {
            for (unsigned d = 0; d < 8; ++d) { // not out_edges: a step may lead in one direction only
                const int x = int(p.x) + detail::direction_x[d], y = int(p.y) + detail::direction_y[d];
                if (x < 0 || y < 0 || x >= int(map.width()) || y >= int(map.height())) continue;
                const Cell n{std::uint16_t(x), std::uint16_t(y)};
                if (map.passable(n, p) && place.of(n).stamp == closed) use(n, place.of(n));
            }
        };
        each_closed([&](Cell n, const auto& other) {
            const Cost g = other.g + tiles<Cost>(n, p);
            if (g < node.g) node.g = g, node.parent = n;
        });
        each_closed([&](Cell, const auto& other) {
            const Cell far = other.parent;
            const Cost g = place.of(far).g + tiles<Cost>(far, p);
            if (g < node.g && !(far == refused) && line_of_sight(map, far, p)) node.g = g, node.parent = far;
        });
    }
    template <class Work, class Place, class Node, class Watcher>
    static void expand(Work& work, const Place& place, Cell p, const Node& node, std::uint32_t open, Watcher& watcher) {
        using Cost = typename Work::Cost;
        const auto& map = work.graph();
        const Cell from = node.parent;
        const Cost before = place.of(from).g;
        const auto edges = out_edges(p, map);
        for (auto at = edges.first; at != edges.second; ++at) {
            const Cell q = target(*at, map);
            auto& next = place.of_target(*at, q);
            if (next.stamp == open + 1) continue;
            const Cost g = before + tiles<Cost>(from, q);
            const bool first = next.stamp < open;
            if (!first && !(g < next.g)) continue;
            if (first) next.h = work.estimate(q), ++work.generated;
            next.g = g, next.parent = from, next.stamp = open;
            work.queue.push(next.f(), next.h, q);
            if (first) watcher.opened(q, next);
            else watcher.improved(q, next);
        }
    }
};

} // namespace ansatz::paths
