// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What a search asks of a graph: Boost.Graph's concepts, found by its own free functions, and a few optional ones.
///
/// Needed: `out_edges(v, g)` and `target(e, g)` (an IncidenceGraph), a property map of weights (`get(boost::edge_weight,
/// g)`, or the policy `WeightsOf{map}`), and either numbered vertices (`get(boost::vertex_index, g)` and
/// `num_vertices(g)`, or `IndexOf{map, count}`) or vertices that std::hash knows, for graphs too large to be numbered.
///
/// Asked for where there are such, found by argument-dependent lookup:
///
/// | function                                   | what for                                                            |
/// |--------------------------------------------|---------------------------------------------------------------------|
/// | `is_passable(v, g)`, `is_passable(e, g)`   | the notes' flags on nodes and edges (6.1, 6.3)                      |
/// | `is_blocked(v, g)`                         | the same of start and goal, where out_edges leaves blocked ones out |
/// | `has_vertex(v, g)`                         | start and goal are refused at the door when they are outside        |
/// | `name_of(v, g)`                            | sentences about a node                                              |
/// | `cost_in_words(c, g)`                      | sentences about a cost                                              |
/// | `edge_weights(g, std::type_identity<C>{})` | the weights in the number C, where a graph can say them in several  |
/// | `target_index(e, map)`                     | the number of an edge's target, where the graph has it at hand      |
///
/// boost::filtered_graph works too: it is Boost.Graph's own way to leave nodes and edges out.

#include <ansatz/paths/cost.hpp>
#include <ansatz/units/describe.hpp>

#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>
#include <boost/pending/property.hpp>
#include <boost/property_map/property_map.hpp>

#include <concepts>
#include <cstddef>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>

namespace ansatz::paths {

/// What names a vertex of this graph.
template <class Graph> using VertexOf = typename boost::graph_traits<Graph>::vertex_descriptor;
/// What names an edge of this graph.
template <class Graph> using EdgeOf = typename boost::graph_traits<Graph>::edge_descriptor;

/// Weights kept outside the graph: `AStar{graph, heuristic, WeightsOf{map}}`, a readable property map of its edges.
template <class Map> struct WeightsOf {
    using role = roles::Weights;
    Map map; ///< from an edge to its weight
};
/// `WeightsOf{map}` holds this map.
template <class Map> WeightsOf(Map) -> WeightsOf<Map>;

/// Numbers of the vertices kept outside the graph, from 0 to below `count`: `AStar{graph, heuristic, IndexOf{map, n}}`.
template <class Map> struct IndexOf {
    using role = roles::Index;
    Map map;               ///< from a vertex to its number
    std::size_t count = 0; ///< how many vertices there are
};
/// `IndexOf{map, count}` holds this map.
template <class Map> IndexOf(Map, std::size_t) -> IndexOf<Map>;

/// What every graph must be: Boost.Graph's IncidenceGraph, as far as a search uses it.
template <class Graph>
concept SearchGraph = requires(const Graph& g, VertexOf<Graph> v, EdgeOf<Graph> e) {
    out_edges(v, g);
    { target(e, g) } -> std::convertible_to<VertexOf<Graph>>;
};

/// Where a search may end: a vertex, or whatever the graph declares as its `goal_type` (a condition that many meet).
namespace detail {
template <class Graph> struct GoalTrait {
    using type = VertexOf<Graph>;
};
template <class Graph>
    requires requires { typename Graph::goal_type; }
struct GoalTrait<Graph> {
    using type = typename Graph::goal_type;
};

/// For graphs without weights: every edge costs one.
template <class Cost> struct OneEach {};
template <class Cost, class Edge> constexpr Cost get(OneEach<Cost>, const Edge&) { return Cost(1); }

struct NotGiven {};

/// Whether Boost.Graph's own containers have a property: to ask them for one they lack is an error inside of them. The views
/// of Boost.Graph (filtered_graph, reverse_graph) have what the graph in their m_g has.
template <class Graph, class Tag> constexpr bool has_property() {
    using boost::lookup_one_property;
    if constexpr (requires {
                      typename Graph::vertex_list_selector;
                      typename Graph::edge_property_type;
                  }) {
        if constexpr (std::is_same_v<Tag, boost::vertex_index_t>)
            return std::is_integral_v<VertexOf<Graph>> ||
                   lookup_one_property<typename Graph::vertex_property_type, Tag>::found;
        else return lookup_one_property<typename Graph::edge_property_type, Tag>::found;
    } else if constexpr (requires(const Graph& g) { g.m_g; })
        return has_property<std::decay_t<decltype(std::declval<const Graph&>().m_g)>, Tag>();
    else return true;
}

template <class Graph>
concept HasWeights = has_property<Graph, boost::edge_weight_t>() &&
                     requires(const Graph& g, EdgeOf<Graph> e) { get(get(boost::edge_weight, g), e); };
template <class Graph, class Cost>
concept HasWeightsIn = requires(const Graph& g) { edge_weights(g, std::type_identity<Cost>{}); };
template <class Graph>
concept IsNumbered = has_property<Graph, boost::vertex_index_t>() && requires(const Graph& g, VertexOf<Graph> v) {
    { get(get(boost::vertex_index, g), v) } -> std::convertible_to<std::size_t>;
    { num_vertices(g) } -> std::convertible_to<std::size_t>;
};
template <class Vertex>
concept IsHashed = requires(const Vertex& v) {
    { std::hash<Vertex>{}(v) } -> std::convertible_to<std::size_t>;
    { v == v } -> std::convertible_to<bool>;
};

template <class Graph> [[gnu::always_inline]] inline bool vertex_passable(const VertexOf<Graph>& v, const Graph& g) {
    if constexpr (requires {
                      { is_passable(v, g) } -> std::convertible_to<bool>;
                  })
        return is_passable(v, g);
    else return true;
}
template <class Graph> [[gnu::always_inline]] inline bool edge_passable(const EdgeOf<Graph>& e, const Graph& g) {
    // Where the vertices already are numbers an edge must not be mistaken for one.
    if constexpr (requires {
                      { is_passable(e, g) } -> std::convertible_to<bool>;
                  })
        return is_passable(e, g);
    else return true;
}
/// The flag of a vertex that is to be a start or a goal, for graphs whose out_edges leaves blocked ones out by itself.
template <class Graph> bool blocked(const VertexOf<Graph>& v, const Graph& g) {
    if constexpr (requires {
                      { is_blocked(v, g) } -> std::convertible_to<bool>;
                  })
        return is_blocked(v, g);
    else return !vertex_passable(v, g);
}
template <class Graph> bool contains(const VertexOf<Graph>& v, const Graph& g) {
    if constexpr (requires {
                      { has_vertex(v, g) } -> std::convertible_to<bool>;
                  })
        return has_vertex(v, g);
    else if constexpr (std::integral<VertexOf<Graph>> && requires { num_vertices(g); }) return v < num_vertices(g);
    else return true;
}
template <class Graph> [[gnu::cold]] std::string name_of_vertex(const VertexOf<Graph>& v, const Graph& g) {
    if constexpr (requires {
                      { name_of(v, g) } -> std::convertible_to<std::string>;
                  })
        return name_of(v, g);
    else if constexpr (std::is_arithmetic_v<VertexOf<Graph>>) return describe(v);
    else if constexpr (IsNumbered<Graph>) return describe(get(get(boost::vertex_index, g), v));
    else return "of this graph";
}
template <class Cost, class Graph> [[gnu::cold]] std::string name_of_cost(const Cost& cost, const Graph& g) {
    if constexpr (requires {
                      { cost_in_words(cost, g) } -> std::convertible_to<std::string>;
                  })
        return cost_in_words(cost, g);
    else return describe(cost);
}
template <class Graph> [[gnu::cold]] std::string size_of_graph(const Graph& g) {
    if constexpr (requires {
                      { size_in_words(g) } -> std::convertible_to<std::string>;
                  })
        return size_in_words(g);
    else if constexpr (requires { num_vertices(g); })
        return "the graph has the vertices 0 to " + std::to_string(num_vertices(g)) + " without the last";
    else return "the graph has no such vertex";
}

/// The weights: those that were given, else the graph's own in this number, else the graph's own, else one each.
template <class Graph, class Cost, class Given> decltype(auto) weights_of(const Graph& g, const Given& given) {
    if constexpr (!std::is_same_v<Given, NotGiven>) return given.map;
    else if constexpr (HasWeightsIn<Graph, Cost>) return edge_weights(g, std::type_identity<Cost>{});
    else if constexpr (HasWeights<Graph>) return get(boost::edge_weight, g);
    else return OneEach<Cost>{};
}
/// The number that a graph's weights are, where nobody chose another.
template <class Graph, class Given> struct NaturalCost {
    using map =
        std::decay_t<decltype(weights_of<Graph, int>(std::declval<const Graph&>(), std::declval<const Given&>()))>;
    using type = std::decay_t<decltype(get(std::declval<map>(), std::declval<EdgeOf<Graph>>()))>;
};
template <class Graph, class Given>
    requires requires { typename Graph::default_cost; } && std::is_same_v<Given, NotGiven>
struct NaturalCost<Graph, Given> {
    using type = typename Graph::default_cost;
};

} // namespace detail

/// What a search on this graph is to reach: a vertex, or the graph's own `goal_type`.
template <class Graph> using GoalOf = typename detail::GoalTrait<Graph>::type;

} // namespace ansatz::paths
