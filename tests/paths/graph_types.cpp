// SPDX-License-Identifier: BSL-1.0
// Every type of graph that Boost.Graph has, with weights of every kind, and its views of another graph: the search
// finds what a plain model finds on the same edges.

#include "tests/paths/support.hpp"

#include <ansatz/paths/a_star.hpp>
#include <ansatz/paths/boost_a_star.hpp>
#include <ansatz/paths/flow_field.hpp>
#include <ansatz/paths/true_costs.hpp>

#include <boost/graph/adjacency_matrix.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/graph/filtered_graph.hpp>
#include <boost/graph/grid_graph.hpp>
#include <boost/graph/reverse_graph.hpp>
#include <boost/graph/subgraph.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <vector>

using namespace paths_tests;

namespace {

struct Street {
    int km = 1;
};
using Weighed = boost::property<boost::edge_weight_t, int>;
template <class Out, class Vertices, class Directed, class Edge = boost::no_property>
using List = boost::adjacency_list<Out, Vertices, Directed, boost::no_property, Edge>;
using boost::bidirectionalS, boost::directedS, boost::listS, boost::setS, boost::undirectedS, boost::vecS;

/// The model: edges in a row, each pair of vertices once, and Bellman and Ford's costs.
struct Model {
    struct Edge {
        std::size_t from, to;
        int weight;
    };
    std::size_t n = 0;
    std::vector<Edge> edges;
    static constexpr int none = std::numeric_limits<int>::max();
    Model(std::mt19937& random, std::size_t vertices, bool both_ways) : n(vertices) {
        for (std::size_t a = 0; a < n; ++a)
            for (std::size_t b = both_ways ? a + 1 : 0; b < n; ++b)
                if (a != b && random() % 5 == 0) edges.push_back({a, b, int(random() % 9)});
    }
    template <class Weight, class Free>
    int cost(std::size_t start, std::size_t goal, bool both_ways, Weight&& weight, Free&& free) const {
        if (!free(start) || !free(goal)) return none;
        std::vector<int> costs(n, none);
        costs[start] = 0;
        const auto relax = [&](std::size_t a, std::size_t b, int w) {
            if (costs[a] != none && free(a) && free(b)) costs[b] = std::min(costs[b], costs[a] + w);
        };
        for (std::size_t round = 0; round < n; ++round)
            for (const auto& e : edges) {
                relax(e.from, e.to, weight(e));
                if (both_ways) relax(e.to, e.from, weight(e));
            }
        return costs[goal];
    }
    int cost(std::size_t start, std::size_t goal, bool both_ways, bool weighed) const {
        return cost(
            start, goal, both_ways, [&](const Edge& e) { return weighed ? e.weight : 1; },
            [](std::size_t) { return true; });
    }
};
/// Whether the search answers as the model.
template <class Search, class Vertex> void agree(Search&& search, const Vertex& start, const Vertex& goal, int best) {
    const Outcome outcome = search.find(start, goal);
    INFO(search.why());
    REQUIRE((outcome == Outcome::found) == (best != Model::none));
    if (outcome == Outcome::found) REQUIRE(search.cost() == best);
}
template <class Graph> Graph built(const Model& m) {
    Graph g(m.n);
    std::vector<typename boost::graph_traits<Graph>::vertex_descriptor> all(vertices(g).first, vertices(g).second);
    for (const auto& e : m.edges) {
        if constexpr (std::is_same_v<typename Graph::edge_property_type, Street>)
            add_edge(all[e.from], all[e.to], Street{e.weight}, g);
        else if constexpr (std::is_same_v<typename Graph::edge_property_type, Weighed>)
            add_edge(all[e.from], all[e.to], Weighed(e.weight), g);
        else add_edge(all[e.from], all[e.to], g);
    }
    return g;
}
/// A graph and policies against the model, from every vertex to one.
template <class Graph, class... Policies>
void check(const Model& m, const Graph& g, bool both_ways, bool weighed, const Policies&... policies) {
    const std::vector<VertexOf<Graph>> all(vertices(g).first, vertices(g).second);
    AStar search{g, policies...};
    for (std::size_t v = 0; v < m.n; ++v) agree(search, all[v], all[m.n - 1], m.cost(v, m.n - 1, both_ways, weighed));
}
/// One type of graph with the three kinds of weights that it may have inside, and those beside it.
template <template <class> class Of> void check_kinds(bool both_ways) {
    std::mt19937 random(51);
    for (int k = 0; k < 6; ++k) {
        const Model m(random, 9, both_ways);
        const auto bare = built<Of<boost::no_property>>(m);
        check(m, bare, both_ways, false);
        const auto weighed = built<Of<Weighed>>(m);
        check(m, weighed, both_ways, true);
        const auto streets = built<Of<Street>>(m);
        check(m, streets, both_ways, true, WeightsOf{get(&Street::km, streets)});
        check(m, streets, both_ways, false, UnitWeights{});
    }
}
template <class Edge> using Vectors = List<vecS, vecS, directedS, Edge>;
template <class Edge> using Both = List<vecS, vecS, undirectedS, Edge>;
template <class Edge> using Sets = List<setS, vecS, bidirectionalS, Edge>;
template <class Edge> using Linked = List<listS, listS, directedS, Edge>;
template <class Edge> using Matrix = boost::adjacency_matrix<directedS, boost::no_property, Edge>;
template <class Edge> using MatrixOfBoth = boost::adjacency_matrix<undirectedS, boost::no_property, Edge>;

} // namespace

TEST_CASE("adjacency lists and matrices of every kind, with every kind of weights", "[paths]") {
    check_kinds<Vectors>(false);
    check_kinds<Both>(true);
    check_kinds<Sets>(false);
    check_kinds<Linked>(false);
    check_kinds<Matrix>(false);
    check_kinds<MatrixOfBoth>(true);
    std::mt19937 random(52);
    const Model m(random, 12, false); // and by Boost's loop, which lists the vertices
    const auto matrix = built<Matrix<boost::no_property>>(m);
    check(m, matrix, false, false, BoostAStar{});
    const auto weighed = built<Matrix<Weighed>>(m);
    check(m, weighed, false, true, BoostAStar{});
    const auto costs = true_costs<int>(weighed, 11);
    for (std::size_t v = 0; v < 12; ++v) REQUIRE(costs[v] == m.cost(v, 11, false, true));
}

TEST_CASE("rows, subgraphs and reversed graphs", "[paths]") {
    std::mt19937 random(53);
    for (int k = 0; k < 6; ++k) {
        const Model m(random, 10, false);
        std::vector<std::pair<std::size_t, std::size_t>> ends;
        std::vector<Street> lengths;
        for (const auto& e : m.edges) ends.emplace_back(e.from, e.to), lengths.push_back({e.weight});
        const boost::compressed_sparse_row_graph<directedS> bare(boost::edges_are_unsorted_multi_pass, ends.begin(),
                                                                 ends.end(), m.n);
        check(m, bare, false, false);
        const boost::compressed_sparse_row_graph<directedS, boost::no_property, Street> rows(
            boost::edges_are_unsorted_multi_pass, ends.begin(), ends.end(), lengths.begin(), m.n);
        check(m, rows, false, true, WeightsOf{get(&Street::km, rows)});

        const auto both = built<Sets<Weighed>>(m);
        Model turned = m;
        for (auto& e : turned.edges) std::swap(e.from, e.to);
        check(turned, boost::make_reverse_graph(both), false, true);
        const auto none = built<Sets<boost::no_property>>(m);
        check(turned, boost::make_reverse_graph(none), false, false);

        using Whole =
            boost::subgraph<List<vecS, vecS, directedS, boost::property<boost::edge_index_t, std::size_t, Weighed>>>;
        Whole whole(m.n);
        for (const auto& e : m.edges) put(boost::edge_weight, whole, add_edge(e.from, e.to, whole).first, e.weight);
        check(m, whole, false, true);
        Whole& part = whole.create_subgraph(); // every vertex but the first two, in the same order
        for (std::size_t v = 2; v < m.n; ++v) add_vertex(v, part);
        AStar search{part};
        for (std::size_t v = 2; v < m.n; ++v)
            agree(search, v - 2, m.n - 3,
                  m.cost(
                      v, m.n - 1, false, [](const auto& e) { return e.weight; }, [](std::size_t u) { return u >= 2; }));
    }
}

TEST_CASE("filtered graphs of every type; what is filtered out is blocked, as start and as goal", "[paths]") {
    std::mt19937 random(54);
    int blocked = 0, found = 0;
    const auto check_filtered = [&](const Model& m, const auto& inner, bool weighed, const auto&... policies) {
        using Inner = std::decay_t<decltype(inner)>;
        const std::vector<VertexOf<Inner>> all(vertices(inner).first, vertices(inner).second);
        std::vector<bool> shut(m.n);
        for (std::size_t v = 0; v < m.n; ++v) shut[v] = random() % 4 == 0;
        const std::function<bool(VertexOf<Inner>)> free = [&](const VertexOf<Inner>& v) {
            return !shut[std::size_t(std::find(all.begin(), all.end(), v) - all.begin())];
        };
        const boost::filtered_graph<Inner, boost::keep_all, std::function<bool(VertexOf<Inner>)>> left(
            inner, boost::keep_all{}, free);
        const boost::filtered_graph<std::decay_t<decltype(left)>, boost::keep_all> twice(left, boost::keep_all{});
        AStar search{left, policies...};
        AStar of_view{twice, policies...};
        for (std::size_t v = 0; v < m.n; ++v)
            for (const std::size_t goal : {std::size_t(0), m.n - 1, v}) {
                const int best = m.cost(
                    v, goal, false, [&](const auto& e) { return weighed ? e.weight : 1; },
                    [&](std::size_t u) { return !shut[u]; });
                agree(search, all[v], all[goal], best);
                REQUIRE((search.outcome() == Outcome::blocked) == (shut[v] || shut[goal]));
                agree(of_view, all[v], all[goal], best);
                blocked += shut[v], found += best != Model::none;
            }
    };
    for (int k = 0; k < 5; ++k) {
        const Model m(random, 10, false);
        check_filtered(m, built<Vectors<boost::no_property>>(m), false);
        check_filtered(m, built<Vectors<Weighed>>(m), true);
        const auto streets = built<Vectors<Street>>(m);
        check_filtered(m, streets, true, WeightsOf{get(&Street::km, streets)});
        check_filtered(m, built<Matrix<boost::no_property>>(m), false);
        check_filtered(m, built<Linked<Weighed>>(m), true);
    }
    CHECK(blocked > 100);
    CHECK(found > 100);
}

TEST_CASE("Boost.Graph's own maze: a filtered grid_graph", "[paths]") {
    std::mt19937 random(55);
    using Board = boost::grid_graph<2>;
    using Place = VertexOf<Board>;
    for (int k = 0; k < 20; ++k) {
        const Board board(boost::array<std::size_t, 2>{{7, 6}});
        std::vector<bool> wall(42);
        for (std::size_t i = 0; i < 42; ++i) wall[i] = random() % 4 == 0;
        const std::function<bool(Place)> free = [&](const Place& p) {
            return !wall[get(boost::vertex_index, board, p)];
        };
        const boost::filtered_graph<Board, boost::keep_all, std::function<bool(Place)>> maze(board, boost::keep_all{},
                                                                                             free);
        Grid<Four> tiles(7, 6); // the same map
        for (std::size_t i = 0; i < 42; ++i)
            tiles.set_passable(Cell{std::uint16_t(i % 7), std::uint16_t(i / 7)}, !wall[i]);
        AStar open{board};
        AStar search{maze};
        AStar by_boost{maze, BoostAStar{}};
        AStar model{tiles};
        for (int q = 0; q < 20; ++q) {
            const Cell a = random_cell(random, 7, 6), b = random_cell(random, 7, 6);
            const Place from{{a.x, a.y}}, to{{b.x, b.y}};
            model.find(a, b);
            REQUIRE(search.find(from, to) == model.outcome());
            REQUIRE(by_boost.find(from, to) == model.outcome());
            if (model.outcome() == Outcome::found) {
                REQUIRE(search.path().size() == model.path().size());
                REQUIRE(by_boost.path().size() == model.path().size());
            }
            REQUIRE(open.find(from, to) == Outcome::found);
            REQUIRE(open.cost() == std::abs(int(a.x) - b.x) + std::abs(int(a.y) - b.y));
        }
    }
}

TEST_CASE("flags and names of a graph hold in a view of it", "[paths]") {
    const auto map = [] {
        Grid<> m(5, 5);
        m.set_passable(Cell{2, 2}, false);
        return m;
    }();
    const boost::filtered_graph<Grid<>, boost::keep_all> view(map, boost::keep_all{});
    AStar search{view};
    CHECK(search.find(Cell{2, 2}, Cell{2, 2}) == Outcome::blocked);
    CHECK(search.find(Cell{0, 0}, Cell{2, 2}) == Outcome::blocked);
    CHECK_THAT(search.why(), ContainsSubstring("from (0, 0) to (2, 2)"));
    CHECK_THAT(test::refusal([&] { search.find(Cell{9, 9}, Cell{0, 0}); }), ContainsSubstring("start is (9, 9)"));
    CHECK(search.find(Cell{1, 1}, Cell{3, 3}) == Outcome::found);
    CHECK(search.cost() == 4);
}

TEMPLATE_TEST_CASE("a weight that is more than the search's number holds is no way, and none that begins again at 0",
                   "[paths]", std::int64_t, std::uint64_t) {
    using Wide = List<vecS, vecS, directedS, boost::property<boost::edge_weight_t, TestType>>;
    constexpr auto first_beyond = TestType(1) << 32;
    for (const TestType heavy : {first_beyond - 1, first_beyond, first_beyond + 1, 7 * first_beyond + 3}) {
        CAPTURE(heavy);
        Wide g(3);
        add_edge(0, 1, heavy, g);
        AStar direct{g, CostIn<std::uint32_t>{}};
        CHECK(direct.find(0, 1) == Outcome::too_far);
        AStar by_boost{g, CostIn<std::uint32_t>{}, BoostAStar{}};
        CHECK(by_boost.find(0, 1) == Outcome::too_far);
        FlowField field{g, CostIn<std::uint32_t>{}};
        CHECK(field.aim(1) == Outcome::too_far);
        CHECK(true_costs<std::uint32_t>(g, 1)[0] == std::numeric_limits<std::uint32_t>::max());
        AStar whole{g};
        CHECK(whole.find(0, 1) == Outcome::found);
        CHECK(whole.cost() == heavy);
        add_edge(0, 2, TestType(10), g); // and the way round is found
        add_edge(2, 1, TestType(10), g);
        CHECK(direct.find(0, 1) == Outcome::found);
        CHECK(direct.cost() == 20);
        CHECK(by_boost.find(0, 1) == Outcome::found);
        CHECK(by_boost.cost() == 20);
        CHECK(field.aim(1) == Outcome::found);
        CHECK(field.cost(0) == 20);
    }
}

TEST_CASE("before a search is begun there is no vertex to name, where vertices are pointers too", "[paths]") {
    using Pointed =
        boost::adjacency_list<vecS, listS, directedS, boost::property<boost::vertex_index_t, std::size_t>, Weighed>;
    Pointed g;
    const auto a = add_vertex(0, g), b = add_vertex(1, g);
    add_edge(a, b, 3, g);
    AStar search{g};
    AStar any{g, AnyGoal{}};
    for (const auto& said : {search.why(), any.why()}) CHECK(said == "no search was begun");
    const std::array<Pointed::vertex_descriptor, 0> nobody{};
    CHECK_THAT(test::refusal([&] { any.find(a, nobody); }), ContainsSubstring("the number of goals is 0"));
    CHECK(any.why() == "no search was begun");
    CHECK(search.find(a, b) == Outcome::found);
    CHECK(search.why() == "the path from 0 to 1 costs 3");
}
