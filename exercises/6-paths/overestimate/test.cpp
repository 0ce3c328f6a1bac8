// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on estimates that are too much (notes 6.1).

#include "tools/exercises/expect.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>

using namespace ansatz::workbook;

namespace {

using exercise::Edge;

constexpr double infinity = std::numeric_limits<double>::infinity();
using Numbers = std::vector<double>;

/// A graph, whose goal is the last node, and an estimate.
struct Scene {
    std::vector<Edge> edges;
    Numbers h;
};

/// What it costs to come from each node to `to`: lowered step by step, as long as an edge lowers it.
Numbers costs_to(const std::vector<Edge>& edges, std::size_t nodes, std::size_t to) {
    Numbers cost(nodes, infinity);
    cost[to] = 0;
    for (bool lowered = true; lowered;) {
        lowered = false;
        for (const Edge& e : edges)
            if (e.cost + cost[e.to] < cost[e.from]) cost[e.from] = e.cost + cost[e.to], lowered = true;
    }
    return cost;
}
Numbers true_costs(const Scene& s) { return costs_to(s.edges, s.h.size(), s.h.size() - 1); }

/// Whether h falls between any two nodes by more than the cheapest way costs. No single edge is tested.
bool falls_too_much(const Scene& s) {
    for (std::size_t to = 0; to < s.h.size(); ++to) {
        const Numbers cost = costs_to(s.edges, s.h.size(), to);
        for (std::size_t v = 0; v < s.h.size(); ++v)
            if (s.h[v] - s.h[to] > cost[v] + 1e-12) return true;
    }
    return false;
}

/// Graphs of one-way edges, whose costs and estimates are halves, so that sums of them are exact.
struct Random {
    std::uint32_t state = 5;
    int below(int n) {
        state = state * 1664525u + 1013904223u;
        return int((state >> 8) % std::uint32_t(n));
    }
    double half(int n) { return 0.5 * below(n); }
};
/// \param of_truth how much of the true cost h is, before a random part is added
std::vector<Scene> scenes(double of_truth, int random_halves) {
    Random random;
    std::vector<Scene> all;
    for (int i = 0; i < 20; ++i) {
        Scene s;
        s.h.assign(7, 0.0);
        for (std::size_t v = 0; v < 7; ++v)
            for (int k = 0; k < 3; ++k) {
                const std::size_t to = std::size_t(random.below(7));
                if (to != v) s.edges.push_back({v, to, 0.5 + random.half(12)});
            }
        const Numbers truth = true_costs(s);
        for (std::size_t v = 0; v + 1 < 7; ++v)
            s.h[v] = of_truth * (truth[v] < infinity ? truth[v] : 20) + random.half(random_halves);
        all.push_back(s);
    }
    return all;
}
const char* const letters = "ABCDEFGHIJKLMNOP";
std::string said(const Scene& s) {
    std::ostringstream text;
    text << "the edges";
    for (const Edge& e : s.edges) text << ' ' << letters[e.from] << letters[e.to] << ' ' << e.cost;
    text << "; the estimates";
    for (std::size_t v = 0; v < s.h.size(); ++v) text << ' ' << letters[v] << ' ' << s.h[v];
    return text.str();
}
std::string said(std::size_t v) { return v == exercise::nobody ? "nobody" : std::string(1, letters[v]); }
void expect_worst(const Numbers& h, const Numbers& truth, std::size_t right, const std::string& why) {
    const std::size_t yours = exercise::worst_overestimate(h, truth);
    std::ostringstream text;
    text << "node, h and true cost:";
    for (std::size_t v = 0; v < h.size(); ++v) text << "  " << letters[v] << ' ' << h[v] << ' ' << truth[v];
    text << "\n    yours  " << (yours < h.size() || yours == exercise::nobody ? said(yours) : std::to_string(yours))
         << "\n    right  " << said(right) << '\n'
         << why;
    expect(yours == right, text.str());
}
void expect_consistent(const Scene& s, bool right, const std::string& why) {
    expect(exercise::consistent(s.edges, s.h) == right,
           said(s) + "\nyours says that they are " + (right ? "not consistent, and they are.\n" : "consistent.\n") +
               why);
}
Scene with(const Scene& s, double w) {
    Scene scaled = s;
    for (double& h : scaled.h) h *= w;
    return scaled;
}
/// Graphs with estimates that are too much in different places.
std::vector<Scene> all_kinds() {
    std::vector<Scene> all = scenes(1.0, 8);
    for (const auto& [of_truth, random] : {std::pair{0.5, 6}, {0.5, 1}, {0.25, 3}})
        for (const Scene& s : scenes(of_truth, random)) all.push_back(s);
    return all;
}
/// Section 6.1.1: no estimate is too much, but from B to C it falls by 6, over an edge of 3.
const Scene four_nodes{{{0, 1, 3}, {1, 2, 3}, {2, 3, 3}, {0, 2, 8}, {0, 3, 10}}, {9, 6, 0, 0}};
/// A street of five tiles, walked both ways. h counts tiles, but each step costs as much as `cost` says.
Scene street(double cost) {
    Scene s;
    for (std::size_t v = 0; v < 4; ++v)
        s.edges.push_back({v, v + 1, v == 2 ? cost : 3}), s.edges.push_back({v + 1, v, v == 2 ? cost : 3});
    s.h = {4, 3, 2, 1, 0};
    return s;
}

} // namespace

TEST_CASE("the worst of several overestimates is found", "[task-1][worst]") {
    expect_worst({9, 4, 7, 3, 0}, {8, 6, 3, 1, 0}, 2, "At C h is 4 above the true cost, at A by 1 and at D by 2.");
    expect_worst({1, 4, 7, 3, 2}, {8, 6, 9, 3, 0}, 4,
                 "At the goal nothing is left to pay, so that even 2 is too much.");
    expect_worst({5, 6, 6, 3, 0}, {5, 4, 4, 3, 0}, 1, "Of several that are equally bad it is the first.");
}

TEST_CASE("the true cost itself is not too much, and nothing below it", "[task-1][admissible]") {
    expect_worst({8, 6, 3, 1, 0}, {8, 6, 3, 1, 0}, exercise::nobody,
                 "h may be exact: then A* expands nothing but a best path.");
    expect_worst({0, 2, 3, 0, 0}, {8, 6, 3, 1, 0}, exercise::nobody,
                 "An underestimate, however low, never hides the best path. It only costs time.");
}

TEST_CASE("nothing is too much where no way leads to the goal", "[task-1][no-way]") {
    expect_worst({7, 5, 2, 0}, {infinity, 4, infinity, 0}, 1, "The true cost there is infinite, and every h is less.");
    expect_worst({7, 4, 2, 0}, {infinity, 4, infinity, 0}, exercise::nobody,
                 "The true cost there is infinite, and every h is less.");
}

TEST_CASE("between no two nodes h falls by more than the way costs", "[task-2][falls]") {
    for (const Scene& s : all_kinds())
        expect_consistent(s, !falls_too_much(s),
                          "What is right was found by the cheapest way from every node to every other: if no edge is "
                          "too cheap for what h falls by along it, no way is.");
}

TEST_CASE("the true costs are consistent", "[task-2][exact]") {
    for (const Scene& s : scenes(1.0, 1))
        expect_consistent(s, true,
                          "Here h is the true cost. The cheapest way from A goes over B or not; it costs no more than "
                          "the edge to B and the cheapest way from there. On a best path it costs just that.");
}

TEST_CASE("an admissible h may be inconsistent", "[task-2][admissible-is-less]") {
    expect_consistent(four_nodes, false,
                      "No h is more than the true cost, but from B to C it falls by 6, over an edge of 3. C is closed "
                      "for 8 before the way over B, which costs 6, is expanded.");
}

TEST_CASE("away from the goal h may rise by any amount", "[task-2][rises]") {
    expect_consistent({{{0, 1, 2}, {1, 0, 8}, {0, 2, 9}, {1, 2, 9}}, {1, 8, 0}}, true,
                      "From A to B h rises by 7, over an edge of 2. Only a fall is a promise that a way can break; the "
                      "way back from B to A is an edge of its own, and costs 8.");
}

TEST_CASE("with the factor h is consistent", "[task-3][consistent-then]") {
    for (const Scene& s : all_kinds()) {
        const double w = exercise::factor(s.edges, s.h);
        std::ostringstream text;
        text << said(s) << "\nWith your factor, " << w
             << ", h still falls by more than a way costs.\nThe worst edge decides: what it costs, as a share of "
                "what h falls by along it.";
        expect(!falls_too_much(with(s, w)), text.str());
    }
}

TEST_CASE("and with a larger one it is not", "[task-3][no-less]") {
    for (const Scene& s : all_kinds()) {
        const double w = exercise::factor(s.edges, s.h);
        std::ostringstream text;
        text << said(s) << "\nYour factor is " << w << ", but with " << 1.01 * w
             << " h would still be consistent.\nThe lower h is, the more of the map A* expands: take no more from it "
                "than you must.";
        expect(w >= 1 || (w > 0 && falls_too_much(with(s, 1.01 * w))), text.str());
    }
}

TEST_CASE("a consistent h is left alone", "[task-3][left-alone]") {
    for (const double of_truth : {1.0, 0.5})
        for (const Scene& s : scenes(of_truth, 1))
            expect_near(said(s) + "\nthe factor", exercise::factor(s.edges, s.h), 1.0, 1e-12,
                        "h is consistent as it is, so that nothing has to be taken from it; and nobody has asked for "
                        "more.");
}

TEST_CASE("metres on a road that is paid in minutes", "[task-3][road]") {
    // Tiles of 10 m; over most of them one walks for 3 minutes, over one of them a road leads.
    for (const double minutes : {0.5, 2.0}) {
        const Scene s = with(street(minutes), 10);
        expect_near(said(s) + "\nthe factor", exercise::factor(s.edges, s.h), minutes / 10, 1e-9,
                    "h falls by 10 from tile to tile, everywhere. It is the quickest tile that says how little a metre "
                    "may count.");
    }
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    if (task == 1)
        for (const auto& [h, truth] :
             std::vector<std::pair<Numbers, Numbers>>{{{8.5, 4, 7, 3, 0}, {8, 6, 3, 1, 0}},
                                                      {{1, 4, 7, 3, 2}, {8, 6, 9, 3, 0}},
                                                      {{5, 6, 6, 3, 0}, {5, 4, 4, 3, 0}},
                                                      {{8, 6, 3, 1, 0}, {8, 6, 3, 1, 0}},
                                                      {{0, 2, 3, 0, 0}, {8, 6, 3, 1, 0}},
                                                      {{7, 5, 2, 0}, {infinity, 4, infinity, 0}},
                                                      {{7, 4, 2, 0}, {infinity, 4, infinity, 0}}}) {
            const std::size_t node = exercise::worst_overestimate(h, truth);
            numbers.push_back(node == exercise::nobody ? -1 : double(node));
        }
    auto all = all_kinds();
    for (const Scene& s : scenes(1.0, 1)) all.push_back(s);
    all.push_back(four_nodes), all.push_back(street(2)), all.push_back(with(street(0.5), 10));
    if (task == 2)
        for (const Scene& s : all) numbers.push_back(exercise::consistent(s.edges, s.h));
    if (task == 3)
        for (const Scene& s : all) numbers.push_back(exercise::factor(s.edges, s.h));
    return numbers;
}
