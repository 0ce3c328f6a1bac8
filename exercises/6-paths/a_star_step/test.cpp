// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on a turn of A* (notes 6.1).

#include "tools/exercises/expect.hpp"

#include <cstdint>
#include <limits>

using namespace ansatz::workbook;
using exercise::List;
using exercise::nobody;
using exercise::Node;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

std::string name_of(List list) {
    return list == List::open ? "on the open list" : list == List::closed ? "on the closed list" : "on no list";
}
std::string said(const Node& n) {
    std::ostringstream text;
    text << name_of(n.list) << ", g " << n.g << ", h " << n.h << ", parent ";
    if (n.parent == nobody) text << "nobody";
    else text << n.parent;
    return text.str();
}
bool same(const Node& a, const Node& b) { return a.list == b.list && a.g == b.g && a.h == b.h && a.parent == b.parent; }

/// Nodes on lists, and which of them is the most promising.
struct Choice {
    std::vector<Node> nodes;
    std::size_t right;
};
const std::vector<Choice>& choices() {
    static const std::vector<Choice> all = {
        {{{List::open, 1, 9, 0}, {List::open, 4, 2, 0}, {List::open, 2, 7, 0}}, 1},
        {{{List::open, 6, 3, 0}, {List::open, 2, 8, 0}, {List::open, 5, 5, 0}}, 0},
        {{{List::open, 1, 8, 0}, {List::open, 7, 2, 0}, {List::open, 3, 6, 0}}, 1},
        {{{List::open, 4, 2, 0}, {List::open, 9, 0, 0}, {List::open, 4, 2, 0}}, 0},
        {{{List::open, 5, 4, 0}, {List::open, 2, 7, 0}, {List::open, 7, 2, 0}}, 2},
        {{{List::open, 3, 3, 0}, {List::open, 8, 1, 0}}, 0},
    };
    return all;
}
const std::vector<Choice>& choices_among_lists() {
    static const std::vector<Choice> all = {
        {{{List::closed, 0, 4, 0}, {List::open, 1, 5, 0}, {List::none, 0, 0, nobody}}, 1},
        {{{List::open, 1, 3, 1}, {List::closed, 0, 2, 1}, {List::open, 4, 4, 1}}, 0},
        {{{List::closed, 0, 4, 0}, {List::none, 0, 0, nobody}, {List::none, 0, 0, nobody}}, nobody},
        {{}, nobody},
    };
    return all;
}
void expect_choice(const Choice& c, const std::string& why) {
    const std::size_t yours = exercise::most_promising(c.nodes);
    std::ostringstream text;
    for (std::size_t v = 0; v < c.nodes.size(); ++v)
        text << "    node " << v << ": f " << c.nodes[v].f() << ", " << said(c.nodes[v]) << '\n';
    auto shown = [](std::size_t v) { return v == nobody ? std::string("nobody") : std::to_string(v); };
    text << "    yours  " << shown(yours) << "\n    right  " << shown(c.right) << '\n' << why;
    expect(yours == c.right, text.str());
}

/// What node 1 is before node 0, whose g is 3, is looked from; the edge costs `weight`, h of node 1 is 2.
struct Look {
    Node q;
    double weight;
    Node right;
};
std::vector<Node> looked(const Look& look) {
    std::vector<Node> nodes{{List::closed, 3, 4, 0}, look.q, {List::closed, 1, 6, 0}};
    exercise::look_at(nodes, 0, 1, look.weight, 2);
    return nodes;
}
const Node known_open{List::open, 8, 2, 2}, known_closed{List::closed, 8, 2, 2}, unknown{};
const std::vector<Look>& new_ones() {
    static const std::vector<Look> all = {{unknown, 4, {List::open, 7, 2, 0}}, {unknown, 0, {List::open, 3, 2, 0}}};
    return all;
}
const std::vector<Look>& cheaper() {
    static const std::vector<Look> all = {{known_open, 4, {List::open, 7, 2, 0}},
                                          {known_open, 0.5, {List::open, 3.5, 2, 0}}};
    return all;
}
const std::vector<Look>& not_cheaper() {
    static const std::vector<Look> all = {{known_open, 6, known_open},     {known_open, 5, known_open},
                                          {known_open, 9, known_open},     {known_closed, 6, known_closed},
                                          {known_closed, 5, known_closed}, {known_closed, 9, known_closed}};
    return all;
}
const std::vector<Look>& opened_again() {
    static const std::vector<Look> all = {{known_closed, 4, {List::open, 7, 2, 0}}};
    return all;
}
void expect_look(const Look& look, const std::string& why) {
    const auto nodes = looked(look);
    std::ostringstream text;
    text << "P has g 3, an edge of weight " << look.weight << " leads to Q, which is " << said(look.q)
         << "\n    yours  Q is " << said(nodes[1]) << "\n    right  Q is " << said(look.right) << '\n'
         << why;
    expect(same(nodes[1], look.right), text.str());
}

/// A graph of seven nodes with random weights, as a matrix; infinite where there is no edge.
struct Graph {
    double weight[7][7];
    double h[7]; ///< never more than the true cost to node 6, and anything below that
};
Graph graph(std::uint32_t seed) {
    auto random = [&](std::uint32_t below) { return (seed = seed * 1664525u + 1013904223u) / 65536 % below; };
    Graph g{};
    double to[7][7];
    for (int a = 0; a < 7; ++a)
        for (int b = 0; b < 7; ++b)
            to[a][b] = g.weight[a][b] = a == b ? 0 : random(100) < 55 ? double(random(20)) : infinite;
    for (int by = 0; by < 7; ++by)
        for (int a = 0; a < 7; ++a)
            for (int b = 0; b < 7; ++b) to[a][b] = std::min(to[a][b], to[a][by] + to[by][b]);
    for (int v = 0; v < 7; ++v) g.h[v] = to[v][6] == infinite ? 0 : std::floor(to[v][6] * random(101) / 100);
    return g;
}
/// What the best way from node 0 to node 6 costs.
double best_cost(const Graph& g) {
    double cost[7];
    std::fill(cost, cost + 7, infinite);
    cost[0] = 0;
    for (int round = 0; round < 7; ++round)
        for (int a = 0; a < 7; ++a)
            for (int b = 0; b < 7; ++b) cost[b] = std::min(cost[b], cost[a] + g.weight[a][b]);
    return cost[6];
}
/// A whole search with `look_at`. What it finds, or infinity.
double search(const Graph& g) {
    std::vector<Node> nodes(7);
    nodes[0] = {List::open, 0, g.h[0], 0};
    for (int turn = 0; turn < 1000; ++turn) {
        std::size_t p = nobody;
        for (std::size_t v = 0; v < 7; ++v)
            if (nodes[v].list == List::open && (p == nobody || nodes[v].f() < nodes[p].f())) p = v;
        if (p == nobody) return infinite;
        nodes[p].list = List::closed;
        if (p == 6) return nodes[p].g;
        for (std::size_t q = 0; q < 7; ++q)
            if (q != p && g.weight[p][q] < infinite) exercise::look_at(nodes, p, q, g.weight[p][q], g.h[q]);
    }
    return -1;
}

} // namespace

TEST_CASE("the most promising node has the least f, of equal f the least h", "[task-1][least-f]") {
    for (const auto& c : choices())
        expect_choice(c,
                      "f = g + h: what the way here has cost, and what is still to come. The least of it is chosen.");
}

TEST_CASE("only nodes of the open list are chosen", "[task-1][open-only]") {
    for (const auto& c : choices_among_lists())
        expect_choice(c, "What is on the closed list has been expanded, and what is on no list is not known yet.");
}

TEST_CASE("a new node is put on the open list, with g, h and parent", "[task-2][new]") {
    for (const auto& look : new_ones())
        expect_look(look, "The way to Q is the way to P and the edge after it. Its parent is P (2.3.4).");
}

TEST_CASE("where the way by P is cheaper, g and parent change", "[task-2][cheaper]") {
    for (const auto& look : cheaper())
        expect_look(look, "g becomes what the cheaper way costs, and the parent must be the node it leads by (2.3.3).");
}

TEST_CASE("where it is not cheaper, nothing changes", "[task-2][not-cheaper]") {
    for (const auto& look : not_cheaper())
        expect_look(look, "The way that is known is at least as good: leave Q as it is.");
}

TEST_CASE("a closed node to which a cheaper way is found is opened again", "[task-2][opened-again]") {
    for (const auto& look : opened_again())
        expect_look(look, "Its neighbours were given costs by the dearer way. Expanded again, it can correct them.");
}

TEST_CASE("a whole search finds what the best way costs", "[task-2][whole]") {
    for (std::uint32_t seed = 1; seed <= 400; ++seed) {
        const Graph g = graph(seed);
        const double yours = search(g), right = best_cost(g);
        std::ostringstream text;
        text << "a search on random graph " << seed << ", with an estimate that is never too much\n    yours  " << yours
             << "\n    right  " << right;
        if (yours < 0)
            text << "\nYours has not come to an end after 1000 turns: a node goes back to the open list without need.";
        else if (yours < right) text << "\nThere is no way for less: some g is less than its way costs.";
        else text << "\nThere is a cheaper way: what was learnt of some node has not reached the nodes behind it.";
        expect(yours == right, text.str());
    }
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    if (task == 1) {
        for (const auto* all : {&choices(), &choices_among_lists()})
            for (const auto& c : *all) {
                const auto best = exercise::most_promising(c.nodes);
                numbers.push_back(best == exercise::nobody ? -1.0
                                                           : double(best)); // beside 2^64 all others would be zero
            }
        return numbers;
    }
    for (const auto* all : {&new_ones(), &cheaper(), &not_cheaper(), &opened_again()})
        for (const auto& look : *all) {
            const Node q = looked(look)[1];
            numbers.insert(numbers.end(), {double(int(q.list)), q.g, q.h, double(q.parent)});
        }
    return numbers;
}
