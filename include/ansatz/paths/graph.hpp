// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What a search asks of a graph: Boost.Graph's concepts, found by its own free functions, and a few optional ones.
///
/// Needed: `out_edges(v, g)` and `target(e, g)` (an IncidenceGraph), a property map of weights
/// (`get(boost::edge_weight, g)`, or the policy `WeightsOf{map}`), and either numbered vertices
/// (`get(boost::vertex_index, g)` and `num_vertices(g)`, or `IndexOf{map, count}`) or vertices that std::hash knows,
/// for graphs too large to be numbered.
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
/// boost::filtered_graph and boost::reverse_graph work too: what a graph answers to these holds in a view of it, and
/// what is filtered out is blocked. Where the edges carry a structure with members (a bundle), say which one is the
/// weight: `WeightsOf{get(&Street::length, g)}`, or `UnitWeights{}` where every edge costs one.

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

namespace boost {
template <class Graph, class Edges, class Vertices> class filtered_graph;
template <class Graph, class Reference> class reverse_graph;
} // namespace boost

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

namespace detail {
/// For graphs without weights: every edge costs one.
template <class Cost> struct OneEach {};
template <class Cost, class Edge> constexpr Cost get(OneEach<Cost>, const Edge&) { return Cost(1); }
} // namespace detail

/// Every edge costs one, whatever the graph says: `AStar{graph, UnitWeights{}}` finds the path of the fewest edges.
struct UnitWeights {
    using role = roles::Weights;
    detail::OneEach<int> map; ///< from an edge to 1
};

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

struct NotGiven {};

/// Boost.Graph's views of another graph, in which its vertices and edges, flags and weights are as they are there.
template <class Graph> struct View {
    static constexpr bool of_graph = false;
};
template <class Inner, class Edges, class Vertices> struct View<boost::filtered_graph<Inner, Edges, Vertices>> {
    static constexpr bool of_graph = true;
    using Graph = boost::filtered_graph<Inner, Edges, Vertices>;
    using Of = Inner;
    static bool leaves_out(const VertexOf<Graph>& v, const Graph& g) { return !g.m_vertex_pred(v); }
    static const auto& edge_of(const EdgeOf<Graph>& e) { return e; }
};
template <class Inner, class Reference> struct View<boost::reverse_graph<Inner, Reference>> {
    static constexpr bool of_graph = true;
    using Graph = boost::reverse_graph<Inner, Reference>;
    using Of = Inner;
    static bool leaves_out(const VertexOf<Graph>&, const Graph&) { return false; }
    static const auto& edge_of(const EdgeOf<Graph>& e) { return e.underlying_descx; }
};
template <class Graph>
concept IsView = View<Graph>::of_graph;

/// The weights of a graph that is seen through a view, by the view's edges.
template <class Graph, class Map> struct WeightsInside {
    using key_type = EdgeOf<Graph>;
    using value_type = typename boost::property_traits<Map>::value_type;
    using reference = typename boost::property_traits<Map>::reference;
    using category = boost::readable_property_map_tag;
    Map map;
    friend decltype(auto) get(const WeightsInside& weights, const key_type& e) {
        return get(weights.map, View<Graph>::edge_of(e));
    }
};

/// Whether Boost.Graph's own containers have a property: to ask them for one they lack is an error inside of them.
template <class Graph, class Tag> constexpr bool has_property() {
    using boost::lookup_one_property;
    if constexpr (requires {
                      typename Graph::vertex_property_type;
                      typename Graph::edge_property_type;
                  }) {
        if constexpr (std::is_same_v<Tag, boost::vertex_index_t>)
            return std::is_integral_v<VertexOf<Graph>> ||
                   lookup_one_property<typename Graph::vertex_property_type, Tag>::found;
        else return lookup_one_property<typename Graph::edge_property_type, Tag>::found;
    } else return true;
}
template <class Graph> constexpr bool has_weights() {
    if constexpr (IsView<Graph>) return has_weights<typename View<Graph>::Of>();
    else if constexpr (!has_property<Graph, boost::edge_weight_t>()) return false;
    else return requires(const Graph& g, EdgeOf<Graph> e) { get(get(boost::edge_weight, g), e); };
}
template <class Graph> constexpr bool is_numbered() {
    if constexpr (IsView<Graph>) return is_numbered<typename View<Graph>::Of>();
    else if constexpr (!has_property<Graph, boost::vertex_index_t>()) return false;
    else
        return requires(const Graph& g, VertexOf<Graph> v) {
            { get(get(boost::vertex_index, g), v) } -> std::convertible_to<std::size_t>;
            { num_vertices(g) } -> std::convertible_to<std::size_t>;
        };
}
template <class Graph>
concept HasWeights = has_weights<Graph>();
template <class Graph, class Cost>
concept HasWeightsIn = requires(const Graph& g) { edge_weights(g, std::type_identity<Cost>{}); };
template <class Graph>
concept IsNumbered = is_numbered<Graph>();

/// Whether the edges of one of Boost.Graph's containers are a structure of the user's.
template <class Graph> constexpr bool has_bundle() {
    if constexpr (IsView<Graph>) return has_bundle<typename View<Graph>::Of>();
    else if constexpr (requires { typename Graph::edge_bundled; })
        return !std::is_same_v<typename Graph::edge_bundled, boost::no_property>;
    else if constexpr (requires { typename Graph::edge_property_type; })
        return boost::lookup_one_property<typename Graph::edge_property_type, boost::edge_bundle_t>::found;
    else return false;
}
/// One of its members is the weight, most likely, and which is for the user to say.
template <class Graph, class Given> constexpr bool knows_weights() {
    return !std::is_same_v<Given, NotGiven> || HasWeights<Graph> || HasWeightsIn<Graph, double> || !has_bundle<Graph>();
}
/// The sentence that asks for it.
template <class Graph, class Given> struct AsksForWeights {
    static_assert(
        knows_weights<Graph, Given>(),
        "Ansatz paths: the edges of this graph carry a structure of yours, and nothing says which member is the "
        "weight; write WeightsOf{get(&Street::length, graph)}, or UnitWeights{} where every edge costs one");
    static constexpr bool ok = true;
};

/// The numbers of the vertices, where there are such.
template <class Graph> auto index_of(const Graph& g) {
    if constexpr (IsView<Graph>) return index_of(g.m_g);
    else return get(boost::vertex_index, g);
}
/// The weights that a graph has of its own.
template <class Graph> auto own_weights(const Graph& g) {
    if constexpr (IsView<Graph>) {
        using Map = decltype(own_weights(g.m_g));
        return WeightsInside<Graph, Map>{own_weights(g.m_g)};
    } else return get(boost::edge_weight, g);
}
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
    else if constexpr (IsView<Graph>) return vertex_passable(v, g.m_g);
    else return true;
}
template <class Graph> [[gnu::always_inline]] inline bool edge_passable(const EdgeOf<Graph>& e, const Graph& g) {
    // Where the vertices already are numbers an edge must not be mistaken for one.
    if constexpr (requires {
                      { is_passable(e, g) } -> std::convertible_to<bool>;
                  })
        return is_passable(e, g);
    else if constexpr (IsView<Graph>) return edge_passable(View<Graph>::edge_of(e), g.m_g);
    else return true;
}
/// The flag of a vertex that is to be a start or a goal, for graphs whose out_edges leaves blocked ones out by itself.
template <class Graph> bool blocked(const VertexOf<Graph>& v, const Graph& g) {
    if constexpr (requires {
                      { is_blocked(v, g) } -> std::convertible_to<bool>;
                  })
        return is_blocked(v, g);
    else if constexpr (IsView<Graph>) return View<Graph>::leaves_out(v, g) || blocked(v, g.m_g);
    else return !vertex_passable(v, g);
}
template <class Graph> bool contains(const VertexOf<Graph>& v, const Graph& g) {
    if constexpr (requires {
                      { has_vertex(v, g) } -> std::convertible_to<bool>;
                  })
        return has_vertex(v, g);
    else if constexpr (IsView<Graph>) return contains(v, g.m_g);
    else if constexpr (std::integral<VertexOf<Graph>> && requires { num_vertices(g); }) return v < num_vertices(g);
    else return true;
}
template <class Graph> [[gnu::cold]] std::string name_of_vertex(const VertexOf<Graph>& v, const Graph& g) {
    if constexpr (requires {
                      { name_of(v, g) } -> std::convertible_to<std::string>;
                  })
        return name_of(v, g);
    else if constexpr (IsView<Graph>) return name_of_vertex(v, g.m_g);
    else if constexpr (std::is_arithmetic_v<VertexOf<Graph>>) return describe(v);
    else if constexpr (IsNumbered<Graph>) return describe(get(index_of(g), v));
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
    else if constexpr (IsView<Graph>) return size_of_graph(g.m_g);
    else if constexpr (requires { num_vertices(g); })
        return "the graph has the vertices 0 to " + std::to_string(num_vertices(g)) + " without the last";
    else return "the graph has no such vertex";
}

/// The weights: those that were given, else the graph's own in this number, else the graph's own, else one each.
template <class Graph, class Cost, class Given> decltype(auto) weights_of(const Graph& g, const Given& given) {
    if constexpr (!std::is_same_v<Given, NotGiven>) return given.map;
    else if constexpr (HasWeightsIn<Graph, Cost>) return edge_weights(g, std::type_identity<Cost>{});
    else if constexpr (HasWeights<Graph>) return own_weights(g);
    else return OneEach<Cost>{};
}
/// The number that a graph's weights are, where no other was chosen.
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
