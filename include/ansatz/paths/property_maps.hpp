// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `predecessors_of` and `distances_of`: what a search found, as property maps of Boost.Graph.
///
/// For users of Boost.Graph, whose algorithms hand their results on in such maps: read them where they are, or have
/// `write_maps` put them into your own, as boost::dijkstra_shortest_paths would. To walk a path `path()` is enough.
///
/// A search writes down no more than it comes to. Where it has not been, a vertex is its own predecessor and its
/// distance is the dearest cost there is, as Boost.Graph has it for vertices that cannot be reached. The distances of
/// closed nodes are those of the cheapest way (by a heuristic that is never too much); those of open ones may still
/// fall. A search whose goal is nowhere (`GoalWhere{[](auto) { return false; }}`) comes to all that can be reached.

#include <ansatz/paths/graph.hpp>

#include <boost/property_map/property_map.hpp>

namespace ansatz::paths {

/// The vertex before this one on the cheapest way that a search knows; a start's, and that of a vertex to which it has
/// not come, is itself. Valid until the next query.
template <class Search> struct PredecessorMap {
    using key_type = typename Search::Vertex;
    using value_type = typename Search::Vertex;
    using reference = value_type;
    using category = boost::readable_property_map_tag;
    const Search* search; ///< whose nodes these are
    friend value_type get(const PredecessorMap& map, const key_type& v) {
        const auto* node = map.search->node(v);
        return node ? value_type(node->parent) : v;
    }
    /// That of this vertex.
    value_type operator[](const key_type& v) const { return get(*this, v); }
};
/// What the cheapest way to a vertex costs that a search knows, in the number of the search; the dearest cost there is
/// where it has not been. Valid until the next query.
template <class Search> struct DistanceMap {
    using key_type = typename Search::Vertex;
    using value_type = typename Search::Cost;
    using reference = value_type;
    using category = boost::readable_property_map_tag;
    const Search* search; ///< whose nodes these are
    friend value_type get(const DistanceMap& map, const key_type& v) {
        const auto* node = map.search->node(v);
        return node ? node->g : detail::infinite<value_type>;
    }
    /// That of this vertex.
    value_type operator[](const key_type& v) const { return get(*this, v); }
};

/// The predecessors that a search has found.
/// \param search read: it must live as long as the map
template <class Search> PredecessorMap<Search> predecessors_of(const Search& search) { return {&search}; }
/// The distances that a search has found.
/// \param search read: it must live as long as the map
template <class Search> DistanceMap<Search> distances_of(const Search& search) { return {&search}; }

/// Puts what a search has found into maps of yours, for every vertex of its graph (a VertexListGraph).
/// \param predecessors a writable property map from a vertex to a vertex
/// \param distances    a writable property map from a vertex to a cost
template <class Search, class Predecessors, class Distances>
void write_maps(const Search& search, Predecessors predecessors, Distances distances) {
    const auto all = vertices(search.graph());
    for (auto at = all.first; at != all.second; ++at) {
        const typename Search::Vertex v = *at;
        put(predecessors, v, get(predecessors_of(search), v));
        put(distances, v, get(distances_of(search), v));
    }
}

} // namespace ansatz::paths
