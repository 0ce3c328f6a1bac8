// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `EveryEdge`: a node's successors are its neighbours (notes 6.1, step 2.3), and what the role asks of another policy.
///
/// Another policy may leave out nodes that lie on the way to others: `JumpPoints` (grid/jump_points.hpp) does, on
/// grids.

#include <ansatz/paths/roles.hpp>

#include <concepts>
#include <cstddef>

namespace ansatz::paths {

/// Every node that an edge leads to; the default.
struct EveryEdge {
    using role = roles::Successors;
};

/// A policy that finds successors which are more than one edge away on this graph. Its verbs:
///
/// - `each(graph, p, parent, reaches, use)`: the successors of p, which was reached from parent; the start is its own
///   parent. It stops at vertices for which `reaches(v)`, and calls `use(q, edge, n)` for each: q is n edges away, each
///   of which weighs what `edge` weighs. `reaches` has the query's `start` and `goal` as members, for who runs no
///   farther than they are apart.
/// - `between(p, q, use)`: the vertices between a node and its successor, neither included, from q to p.
/// - `require(graph)`: throws std::invalid_argument for a graph as it is now on which it would be wrong.
template <class Policy, class Graph, class Vertex, class Edge>
concept LeapsOn = requires(const Graph& g, const Vertex& v, bool (*reaches)(const Vertex&),
                           void (*use)(const Vertex&, const Edge&, std::size_t), void (*pass)(const Vertex&)) {
    Policy::each(g, v, v, reaches, use);
    Policy::between(v, v, pass);
    Policy::require(g);
};

} // namespace ansatz::paths
