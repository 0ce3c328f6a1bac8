// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `ImplicitGraphTraits`: what Boost.Graph asks of a graph whose edges are made on demand: states of a
/// world, tiles and times, gates between squares. Such a graph has out edges and nothing else: no list of vertices, no
/// edges inwards.
///
/// Use it for a graph of your own that `AStar` searches: `template <> struct boost::graph_traits<Mine> :
/// ansatz::paths::ImplicitGraphTraits<Vertex, Edge, OutEdges> {};` beside `out_edges`, `out_degree` and `target`. A
/// graph that stores its edges takes `boost::adjacency_list`.

#include <ansatz/core/compiler_flags.hpp>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>

namespace ansatz::paths {

/// A base of `boost::graph_traits`: a directed graph with out edges (Boost.Graph's IncidenceGraph).
/// \tparam Vertex   a place in the graph, a value
/// \tparam Edge     a step, a value that knows where it leads
/// \tparam OutEdges a forward iterator over the steps out of a place
/// \tparam Parallel whether two steps may lead from one place to the same other one
template <class Vertex, class Edge, class OutEdges, class Parallel = boost::allow_parallel_edge_tag>
struct ImplicitGraphTraits {
    using vertex_descriptor = Vertex;                      ///< a place
    using edge_descriptor = Edge;                          ///< a step
    using out_edge_iterator = OutEdges;                    ///< over the steps out of a place
    using directed_category = boost::directed_tag;         ///< one way
    using edge_parallel_category = Parallel;               ///< whether two steps may join the same places
    using traversal_category = boost::incidence_graph_tag; ///< out edges, and nothing else
    using degree_size_type = std::size_t;                  ///< of how many steps lead out
    using vertices_size_type = std::size_t;                ///< of how many places there are
    using edges_size_type = std::size_t;                   ///< of how many steps there are
    using adjacency_iterator = void;                       ///< none
    using in_edge_iterator = void;                         ///< none
    using vertex_iterator = void;                          ///< none
    using edge_iterator = void;                            ///< none
};

} // namespace ansatz::paths
