// SPDX-License-Identifier: BSL-1.0
// A* (notes 6.1): the workflow, optimality, what reopening is for, what is refused.

#include "tests/paths/support.hpp"

#include <ansatz/paths/a_star.hpp>
#include <ansatz/paths/boost_a_star.hpp>
#include <ansatz/paths/buckets.hpp>
#include <ansatz/paths/cost.hpp>
#include <ansatz/paths/graph.hpp>
#include <ansatz/paths/heap.hpp>
#include <ansatz/paths/heuristics/by.hpp>
#include <ansatz/paths/heuristics/weighted.hpp>
#include <ansatz/paths/heuristics/zero.hpp>
#include <ansatz/paths/nodes.hpp>
#include <ansatz/paths/outcome.hpp>
#include <ansatz/paths/own_loop.hpp>
#include <ansatz/paths/reopening.hpp>
#include <ansatz/paths/roles.hpp>
#include <ansatz/paths/search.hpp>
#include <ansatz/paths/true_costs.hpp>
#include <ansatz/paths/visitor.hpp>

#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/graph/filtered_graph.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <set>

using namespace paths_tests;

namespace {

/// The petgraph case: with these h, which are admissible, C is closed before the cheap way to it is known.
struct Inconsistent {
    Roads g{4}; // A B C D
    int h[4] = {9, 6, 0, 0};
    Inconsistent() {
        boost::add_edge(0, 1, 3, g), boost::add_edge(1, 2, 3, g), boost::add_edge(2, 3, 3, g);
        boost::add_edge(0, 2, 8, g), boost::add_edge(0, 3, 10, g);
    }
};

/// What a path costs by the graph's own edges; -1 if it is none.
int cost_along(const Roads& g, std::span<const std::size_t> path) {
    int all = 0;
    for (std::size_t i = 1; i < path.size(); ++i) {
        int least = -1;
        for (auto [e, end] = out_edges(path[i - 1], g); e != end; ++e)
            if (target(*e, g) == path[i]) {
                const int w = get(boost::edge_weight, g, *e);
                if (least < 0 || w < least) least = w;
            }
        if (least < 0) return -1;
        all += least;
    }
    return all;
}

std::vector<int> dijkstra(const Roads& g, std::size_t start) {
    std::vector<int> costs(num_vertices(g));
    boost::dijkstra_shortest_paths(g, start, boost::distance_map(costs.data()));
    return costs;
}

} // namespace

TEST_CASE("the notes' workflow: both lists and all four values, step by step", "[paths][P5]") {
    Roads g(5); // 0 -1- 1 -1- 3, 0 -5- 2 -1- 3, 4 alone
    boost::add_edge(0, 1, 1, g), boost::add_edge(0, 2, 5, g), boost::add_edge(1, 3, 1, g), boost::add_edge(2, 3, 1, g);
    const int h[] = {2, 1, 1, 0, 0};
    AStar search{g, By{[&](std::size_t v) { return h[v]; }}};
    CHECK(search.outcome() == Outcome::not_begun);
    search.begin(0, 3);
    CHECK(search.open_list() == std::vector<std::size_t>{0});
    CHECK(search.closed_list().empty());
    CHECK(search.node(0)->f() == 2);
    CHECK(search.advance(1) == Outcome::running);
    CHECK(search.open_list() == std::vector<std::size_t>{1, 2}); // f: 2 and 6
    CHECK(search.closed_list() == std::vector<std::size_t>{0});
    CHECK(search.node(2)->g == 5);
    CHECK(search.node(2)->h == 1);
    CHECK(search.node(2)->f() == 6);
    CHECK(search.node(2)->parent == 0);
    CHECK(search.is_open(1));
    CHECK(search.is_closed(0));
    CHECK(search.node(3) == nullptr);
    CHECK(search.advance(1) == Outcome::running);
    CHECK(search.node(3)->parent == 1);
    CHECK(search.advance(1) == Outcome::found);
    CHECK(std::vector<std::size_t>(search.path().begin(), search.path().end()) == std::vector<std::size_t>{0, 1, 3});
    CHECK(search.cost() == 2);
    CHECK(search.why() == "the path from 0 to 3 costs 2");
    CHECK(search.find(4, 4) == Outcome::found); // the start is the goal
    CHECK(search.path().size() == 1);
    CHECK(search.cost() == 0);
    CHECK(search.find(0, 4) == Outcome::no_path);
    CHECK(search.expanded() == 4); // the component of 0, once
    CHECK(search.path().empty());
    CHECK_THAT(search.why(), ContainsSubstring("there is no path from 0 to 4"));
}

TEST_CASE("every node on the closed list was on the open list before, and a visitor sees it", "[paths]") {
    std::mt19937 random(7);
    const Roads g = random_roads(random, 60, 200, 9);
    AStar search{g};
    Trace<std::size_t> trace;
    search.find(0, 59, search.without_end, trace);
    const std::set<std::size_t> opened(trace.opened_in_order.begin(), trace.opened_in_order.end());
    for (const std::size_t v : trace.closed_in_order) CHECK(opened.count(v) == 1);
    CHECK(trace.opened_in_order.size() == search.generated());
    CHECK(trace.opened_in_order.front() == 0);
    int before = 0;
    for (const std::size_t v : trace.closed_in_order) { // f never falls where the heuristic is consistent
        CHECK(search.node(v)->f() >= before);
        before = search.node(v)->f();
    }
}

TEST_CASE(
    "optimal as Dijkstra on random graphs, with zero edges and inconsistent heuristics, by every queue and engine",
    "[paths]") {
    std::mt19937 random(1);
    int reopened = 0, unreachable = 0;
    for (int k = 0; k < 1000; ++k) {
        const std::size_t n = 2 + random() % 40;
        const Roads g = random_roads(random, n, n + random() % (3 * n), k % 2 == 0 ? 9 : 1000);
        const std::size_t start = random() % n, goal = random() % n;
        const int best = dijkstra(g, start)[goal];
        // Any number up to the true cost: admissible, and mostly inconsistent.
        const auto truth = true_costs<int>(g, goal);
        std::vector<int> h(n);
        for (std::size_t v = 0; v < n; ++v)
            h[v] = truth[v] == std::numeric_limits<int>::max() ? int(random() % 2000)
                                                               : int(random() % (unsigned(truth[v]) + 1));
        const By guess{[&](std::size_t v) { return h[v]; }};
        AStar heap{g, guess};
        AStar buckets{g, guess, Buckets{4}};
        AStar wide{g, guess, Buckets{5000}, CostIn<double>{}};
        AStar blind{g, Buckets{}};
        AStar boost_engine{g, guess, BoostAStar{}};
        auto check = [&](auto& search) {
            const Outcome outcome = search.find(start, goal);
            if (best == std::numeric_limits<int>::max()) return outcome == Outcome::no_path && search.path().empty();
            return outcome == Outcome::found && double(search.cost()) == best && cost_along(g, search.path()) == best &&
                   search.path().front() == start && search.path().back() == goal;
        };
        INFO("graph " << k << ": " << n << " vertices, from " << start << " to " << goal << ", the best costs "
                      << best);
        REQUIRE(check(heap));
        REQUIRE(check(buckets));
        REQUIRE(check(wide));
        REQUIRE(check(blind));
        REQUIRE(check(boost_engine));
        reopened += int(heap.reopened());
        unreachable += best == std::numeric_limits<int>::max();
    }
    CHECK(reopened > 100); // else the case has lost its point
    CHECK(unreachable > 50);
    CHECK(unreachable < 600);
}

TEST_CASE("hard case P1: admissible but inconsistent needs reopening; the notes' step 2.3.3 is not enough", "[paths]") {
    const Inconsistent p;
    const By h{[&](std::size_t v) { return p.h[v]; }};
    AStar right{p.g, h};
    AStar by_buckets{p.g, h, Buckets{}};
    AStar closed{p.g, h, NoReopening{}};
    AStar notes{p.g, h, UpdateClosed{}};
    right.find(0, 3), by_buckets.find(0, 3), closed.find(0, 3), notes.find(0, 3);
    CHECK(right.cost() == 9);
    CHECK(by_buckets.cost() == 9);
    CHECK(right.reopened() > 0);
    CHECK(closed.cost() == 10);
    // The notes update C on the closed list: the path goes through it, but nobody told D, which keeps its 10.
    CHECK(notes.cost() == 10);
}

TEST_CASE("weighted: within w of the best, with and without reopening", "[paths]") {
    std::mt19937 random(3);
    double worst = 1;
    for (int k = 0; k < 300; ++k) {
        const std::size_t n = 5 + random() % 60;
        const Roads g = random_roads(random, n, 4 * n, 50);
        const std::size_t start = random() % n, goal = random() % n;
        const int best = dijkstra(g, start)[goal];
        if (best == std::numeric_limits<int>::max()) continue;
        const auto truth = true_costs<int>(g, goal);
        for (const double w : {1.0, 1.2, 2.0, 5.0}) {
            // Consistent: half of the truth. (What nobody can come from is never asked.)
            const Weighted h{
                By{[&](std::size_t v) { return truth[v] == std::numeric_limits<int>::max() ? 0 : truth[v] / 2.0; }}, w};
            AStar once{g, h, NoReopening{}, CostIn<double>{}};
            AStar again{g, h, CostIn<double>{}};
            REQUIRE(once.find(start, goal) == Outcome::found);
            REQUIRE(again.find(start, goal) == Outcome::found);
            CHECK(once.cost() <= w * best + 1e-9);
            CHECK(again.cost() <= w * best + 1e-9);
            CHECK(cost_along(g, once.path()) <= w * best + 1e-9);
            if (best > 0) worst = std::max(worst, once.cost() / best);
        }
    }
    CHECK(worst > 1.01); // a weight costs something somewhere
    CHECK_THAT(test::refusal([] { Weighted(ZeroHeuristic{}, -1); }), ContainsSubstring("weight is -1"));
    CHECK_THAT(test::refusal([] { Weighted(ZeroHeuristic{}, std::nan("")); }), ContainsSubstring("weight is nan"));
}

TEST_CASE("blocked nodes and edges of any graph: boost::filtered_graph, against Dijkstra on the same", "[paths]") {
    std::mt19937 random(5);
    for (int k = 0; k < 200; ++k) {
        const std::size_t n = 10 + random() % 30;
        const Roads g = random_roads(random, n, 4 * n, 20);
        std::vector<bool> shut(n);
        for (std::size_t v = 0; v < n; ++v) shut[v] = random() % 4 == 0;
        auto edge_free = [&](const Roads::edge_descriptor& e) { return get(boost::edge_weight, g, e) % 5 != 1; };
        auto node_free = [&](std::size_t v) { return !shut[v]; };
        const boost::filtered_graph left(g, std::function<bool(Roads::edge_descriptor)>(edge_free),
                                         std::function<bool(std::size_t)>(node_free));
        const std::size_t start = random() % n, goal = random() % n;
        if (shut[start] || shut[goal]) continue;
        Roads copy(n);
        for (auto [e, end] = edges(g); e != end; ++e)
            if (edge_free(*e) && !shut[source(*e, g)] && !shut[target(*e, g)])
                boost::add_edge(source(*e, g), target(*e, g), get(boost::edge_weight, g, *e), copy);
        const int best = dijkstra(copy, start)[goal];
        AStar search{left};
        const bool found = search.find(start, goal) == Outcome::found;
        REQUIRE(found == (best != std::numeric_limits<int>::max()));
        if (found) REQUIRE(search.cost() == best);
    }
}

TEST_CASE("a search in slices goes the same way as one in one go, and a budget gives what it has", "[paths]") {
    std::mt19937 random(11);
    const auto map = random_map(random, 64, 64, 0.2);
    AStar whole{map}, sliced{map};
    int running = 0;
    for (int k = 0; k < 30; ++k) {
        const Cell a = random_cell(random, 64, 64), b = random_cell(random, 64, 64);
        whole.find(a, b);
        sliced.begin(a, b);
        while (sliced.advance(7) == Outcome::running) ++running;
        CHECK(sliced.outcome() == whole.outcome());
        CHECK(std::equal(sliced.path().begin(), sliced.path().end(), whole.path().begin(), whole.path().end()));
        CHECK(sliced.expanded() == whole.expanded());
        if (whole.outcome() != Outcome::found || whole.expanded() < 20) continue;
        AStar poor{map};
        CHECK(poor.find(a, b, 10) == Outcome::gave_up);
        CHECK(poor.expanded() == 10);
        CHECK(poor.path().front() == a);
        for (const Cell c : poor.closed_list()) CHECK(poor.node(c)->h >= poor.node(poor.path().back())->h);
        CHECK_THAT(poor.why(), ContainsSubstring("gave up after 10 expansions"));
    }
    CHECK(running > 30);
}

TEST_CASE("the stamps begin again without a fault, and a graph may grow between searches", "[paths]") {
    Roads g(3);
    boost::add_edge(0, 1, 1, g), boost::add_edge(1, 2, 1, g);
    AStar search{g};
    search.find(0, 2);
    search.internals().nodes.stamps().use_up();
    for (int k = 0; k < 4; ++k) {
        CHECK(search.find(0, 2) == Outcome::found);
        CHECK(search.cost() == 2);
        CHECK(search.find(2, 0) == Outcome::no_path);
        CHECK(search.expanded() == 1);
    }
    for (std::size_t v = 3; v < 2000; ++v) boost::add_edge(v - 1, v, 1, g);
    CHECK(search.find(0, 1999) == Outcome::found);
    CHECK(search.cost() == 1999);
}

TEST_CASE("what a search is given wrongly it says, and never throws once it has begun", "[paths][P5][P10]") {
    Roads g(3);
    boost::add_edge(0, 1, 1, g);
    const auto bad = boost::add_edge(1, 2, -4, g).first;
    AStar search{g};
    CHECK_THAT(test::refusal([&] { search.find(0, 7); }), ContainsSubstring("AStar: goal is 7"));
    CHECK_THAT(test::refusal([&] { search.find(3, 0); }), ContainsSubstring("AStar: start is 3"));
    CHECK(search.find(0, 2) == Outcome::bad_weight);
    CHECK(search.why() == "the edge from 1 to 2 weighs -4; a weight is a number and not negative");
    AStar by_boost{g, BoostAStar{}};
    CHECK(by_boost.find(0, 2) == Outcome::bad_weight);
    put(boost::edge_weight, g, bad, std::numeric_limits<int>::max() - 1);
    boost::add_edge(0, 2, std::numeric_limits<int>::max(), g);
    CHECK(search.find(0, 2) == Outcome::too_far); // 1 + (max - 1) is the dearest cost there is
    AStar wide{g, CostIn<double>{}};
    CHECK(wide.find(0, 2) == Outcome::found);
    boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS, boost::no_property,
                          boost::property<boost::edge_weight_t, double>>
        d(2);
    const auto e = boost::add_edge(0, 1, std::nan(""), d).first;
    AStar of_doubles{d};
    CHECK(of_doubles.find(0, 1) == Outcome::bad_weight);
    put(boost::edge_weight, d, e, std::numeric_limits<double>::infinity()); // as good as blocked
    CHECK(of_doubles.find(0, 1) == Outcome::no_path);
    for (const double width : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()})
        CHECK_THAT(test::refusal([&] { AStar refused(g, Buckets{width}); }), ContainsSubstring("Buckets: width is"));
}

TEST_CASE("weights and numbers may stand beside the graph, vertices need no numbers at all", "[paths]") {
    using Linked = boost::adjacency_list<boost::listS, boost::listS, boost::directedS>;
    Linked g;
    const auto a = add_vertex(g), b = add_vertex(g), c = add_vertex(g);
    const auto ab = add_edge(a, b, g).first, bc = add_edge(b, c, g).first, ac = add_edge(a, c, g).first;
    AStar hashed{g}; // pointers, and every edge costs one
    CHECK(hashed.find(a, c) == Outcome::found);
    CHECK(hashed.cost() == 1);
    CHECK(hashed.closed_list().size() >= 2);
    std::map<Linked::edge_descriptor, double> weights{{ab, 1.0}, {bc, 1.0}, {ac, 5.0}};
    std::map<Linked::vertex_descriptor, std::size_t> numbers{{a, 0}, {b, 1}, {c, 2}};
    AStar outside{g, WeightsOf{boost::make_assoc_property_map(weights)},
                  IndexOf{boost::make_assoc_property_map(numbers), 3}};
    CHECK(outside.find(a, c) == Outcome::found);
    CHECK(outside.cost() == 2.0);
    AStar many{g, WeightsOf{boost::make_assoc_property_map(weights)}};
    CHECK(many.find(a, c) == Outcome::found);
    CHECK(many.cost() == 2.0);
}

TEST_CASE("weights may be a function, whose map cannot be assigned", "[paths]") {
    struct Street {
        double km = 0, speed = 1;
    };
    using Streets = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property, Street>;
    Streets g(3);
    add_edge(0, 1, {3, 50}, g), add_edge(1, 2, {4, 50}, g), add_edge(0, 2, {6, 30}, g);
    const auto hours = boost::make_function_property_map<Streets::edge_descriptor>(
        [&g](const Streets::edge_descriptor& e) { return g[e].km / g[e].speed; });
    AStar search{g, WeightsOf{hours}};
    AStar by_boost{g, WeightsOf{hours}, BoostAStar{}};
    for (int twice = 0; twice < 2; ++twice) {
        CHECK(search.find(0, 2) == Outcome::found);
        CHECK(search.cost() == Approx(7.0 / 50));
        CHECK(by_boost.find(0, 2) == Outcome::found);
        CHECK(by_boost.cost() == Approx(7.0 / 50));
    }
}

TEST_CASE("an estimate of yours that is below zero or no number counts as nothing, one without end as no way",
          "[paths]") {
    const Grid<> map(12, 9);
    const Cell start{1, 2}, goal{10, 7};
    AStar best{map, ZeroHeuristic{}};
    REQUIRE(best.find(start, goal) == Outcome::found);
    for (const double odd : {-1.0, -1e300, -std::numeric_limits<double>::infinity(), std::nan("")}) {
        const By some{[odd](Cell c) { return (c.x + c.y) % 2 ? odd : 0.0; }};
        AStar whole{map, some};
        CHECK(whole.find(start, goal) == Outcome::found);
        CHECK(whole.cost() == best.cost());
        AStar real{map, some, CostIn<double>{}};
        CHECK(real.find(start, goal) == Outcome::found);
        CHECK(real.cost() == Approx(map.tiles(best.path())));
    }
    AStar negative{map, By{[](Cell c) { return c.x % 2 ? -1 : 0; }}}; // whole, and wraps round
    CHECK(negative.find(start, goal) == Outcome::found);
    CHECK(negative.cost() == best.cost());
    AStar none{map, By{[](Cell) { return std::numeric_limits<double>::infinity(); }}};
    none.begin(start, goal);
    CHECK(none.node(start)->h == std::numeric_limits<std::uint32_t>::max());
}
