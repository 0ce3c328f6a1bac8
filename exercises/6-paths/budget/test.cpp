// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on a search with a budget (notes 6.3.3).

#include "tools/exercises/expect.hpp"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <queue>
#include <random>
#include <tuple>

using namespace ansatz::workbook;
using exercise::Graph;
using exercise::Looked;
using exercise::Outcome;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t without_end = std::size_t(-1);

/// A graph with its estimates, and how it looks if it is a map.
struct Scene {
    Graph graph;
    std::vector<double> h;
    std::size_t start = 0, goal = 0;
    std::string picture;
};
/// A map of four neighbours: '#' is a wall, a digit what it costs to enter a tile, '.' a cost of 1.
Scene map_of(std::vector<std::string> rows) {
    Scene s;
    const int height = int(rows.size()), width = int(rows[0].size());
    const auto number = [&](int x, int y) { return std::size_t(y * width + x); };
    int goal_x = 0, goal_y = 0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            if (rows[std::size_t(y)][std::size_t(x)] == 'S') s.start = number(x, y);
            if (rows[std::size_t(y)][std::size_t(x)] == 'G') s.goal = number(x, y), goal_x = x, goal_y = y;
        }
        s.picture += "    " + rows[std::size_t(y)] + '\n';
    }
    s.graph.resize(std::size_t(width * height));
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            s.h.push_back(std::abs(x - goal_x) + std::abs(y - goal_y));
            if (rows[std::size_t(y)][std::size_t(x)] == '#') continue;
            for (const auto& [to_x, to_y] : {std::pair{x + 1, y}, {x, y + 1}, {x - 1, y}, {x, y - 1}}) {
                if (to_x < 0 || to_y < 0 || to_x >= width || to_y >= height) continue;
                const char tile = rows[std::size_t(to_y)][std::size_t(to_x)];
                if (tile == '#') continue;
                s.graph[number(x, y)].push_back({number(to_x, to_y), tile > '0' && tile <= '9' ? tile - '0' : 1.0});
            }
        }
    return s;
}
/// The castle of section 6.3.3, smaller: the way in is on the far side.
Scene castle(bool locked) {
    return map_of({"..................", "...........#####..", "..S..#.....#...#..",
                   locked ? ".....#.....#.G.#.." : ".....#.....#.G....", ".....#.....#...#..", "...........#####..",
                   ".................."});
}
Scene random_map(unsigned seed) {
    std::mt19937 random(seed);
    std::vector<std::string> rows(9, std::string(20, '.'));
    for (auto& row : rows)
        for (char& tile : row) tile = ".......###..3..5.."[random() % 18];
    rows[4][1] = 'S', rows[random() % 9][18] = 'G';
    return map_of(rows);
}
std::vector<Scene> maps() {
    std::vector<Scene> all{castle(false), castle(true)};
    for (unsigned seed = 1; seed <= 12; ++seed) all.push_back(random_map(seed));
    return all;
}
/// What the best path costs, by going over all edges until none makes anything cheaper: without a heuristic and a list.
double best_cost(const Scene& s) {
    std::vector<double> cost(s.graph.size(), infinity);
    cost[s.start] = 0;
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t v = 0; v < s.graph.size(); ++v)
            for (const auto& edge : s.graph[v])
                if (cost[v] + edge.cost < cost[edge.to]) cost[edge.to] = cost[v] + edge.cost, changed = true;
    }
    return cost[s.goal];
}
std::size_t reachable(const Scene& s) {
    std::vector<bool> seen(s.graph.size(), false);
    std::vector<std::size_t> list{s.start};
    seen[s.start] = true;
    for (std::size_t i = 0; i < list.size(); ++i)
        for (const auto& edge : s.graph[list[i]])
            if (!seen[edge.to]) seen[edge.to] = true, list.push_back(edge.to);
    return list.size();
}

/// A search of the subject's, as far as it has come.
struct Run {
    Outcome outcome = Outcome::running;
    std::size_t calls = 0;
    std::vector<std::size_t> closed; ///< sorted
    std::size_t most_in_a_call = 0;  ///< taken from the open list, but for the goal
    double cost = infinity;          ///< g of the goal
};
Run run(const Scene& scene, std::size_t most) {
    Run r;
    auto search = exercise::begin(scene.graph, scene.h, scene.start, scene.goal);
    std::size_t before = 0;
    while (r.outcome == Outcome::running && r.calls < 400) { // more than any of these maps has nodes
        r.outcome = exercise::advance(search, most);
        ++r.calls;
        const std::size_t now = search.closed.size() - (r.outcome == Outcome::found);
        r.most_in_a_call = std::max(r.most_in_a_call, now - std::min(now, before));
        before = now;
    }
    r.closed = search.closed;
    std::sort(r.closed.begin(), r.closed.end());
    r.cost = search.g[scene.goal];
    return r;
}
std::string said(Outcome outcome) {
    return outcome == Outcome::running ? "running" : outcome == Outcome::found ? "found" : "no_path";
}
std::string slices(std::size_t most) {
    return most == without_end ? "in one call" : "in slices of " + std::to_string(most);
}
std::string legend(const Scene& s) {
    return s.picture.empty() ? "" : "from S to G; a digit is what a tile costs, a point 1\n" + s.picture;
}
void expect_outcome(const Scene& s, std::size_t most, Outcome yours, Outcome right, const std::string& why) {
    expect(yours == right, legend(s) + slices(most) + ", in the end\n    yours  " + said(yours) + "\n    right  " +
                               said(right) + "\n" + why);
}
void expect_count(const std::string& what, std::size_t yours, std::size_t right, const std::string& why) {
    expect(yours == right,
           what + "\n    yours  " + std::to_string(yours) + "\n    right  " + std::to_string(right) + "\n" + why);
}

/// Closed lists of searches that were given up, each in the order in which it came about.
using Lists = std::vector<std::vector<Looked>>;
const Lists& round_a_wall() { // the last ones lead away again
    static const Lists all{{{7, 0, 6}, {8, 1, 5}, {9, 2, 4}, {19, 3, 3}, {18, 4, 4}, {17, 5, 5}, {4, 2, 6}},
                           {{3, 0, 9.5}, {5, 1.5, 8}, {6, 4, 2.5}, {2, 1.5, 8.5}, {11, 2, 8.25}}};
    return all;
}
const Lists& equally_near() {
    static const Lists all{{{20, 0, 5}, {31, 1, 4}, {22, 1, 4}, {13, 2, 5}},
                           {{6, 0, 3}, {5, 4, 2}, {9, 1, 2}, {1, 5, 2}}};
    return all;
}
const Lists& start_is_nearest() {
    static const Lists all{{{14, 0, 2}, {15, 1, 3}, {13, 1, 3}, {4, 2, 4}}, {{8, 0, 7}}};
    return all;
}
void expect_nearest(const Lists& lists, const std::string& why) {
    for (const auto& list : lists) {
        const Looked* right = &list[0];
        std::string text = "expanded, one after the other\n";
        for (const Looked& l : list) {
            std::ostringstream line;
            line << "    node " << l.node << "  g " << l.g << "  h " << l.h << '\n';
            text += line.str();
            if (l.h < right->h) right = &l;
        }
        const std::size_t yours = exercise::nearest(list);
        expect(yours == right->node, text + "the walker goes to\n    yours  node " + std::to_string(yours) +
                                         "\n    right  node " + std::to_string(right->node) + "\n" + why);
    }
}

/// A* that takes its nodes by the subject's f, and opens none of them twice.
struct Hasty {
    double cost = infinity;
    std::size_t looked_at = 0;
};
Hasty hasty(const Scene& s, double w) {
    using Entry = std::tuple<double, double, std::size_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    std::vector<double> g(s.graph.size(), infinity);
    std::vector<bool> closed(s.graph.size(), false);
    Hasty r;
    g[s.start] = 0;
    open.push({exercise::weighted_f(0, s.h[s.start], w), s.h[s.start], s.start});
    while (!open.empty()) {
        const std::size_t p = std::get<2>(open.top());
        open.pop();
        if (closed[p]) continue;
        closed[p] = true;
        if (p == s.goal) {
            r.cost = g[p];
            return r;
        }
        ++r.looked_at;
        for (const auto& edge : s.graph[p]) {
            const std::size_t q = edge.to;
            if (closed[q] || !(g[p] + edge.cost < g[q])) continue;
            g[q] = g[p] + edge.cost;
            open.push({exercise::weighted_f(g[q], s.h[q], w), s.h[q], q});
        }
    }
    return r;
}

} // namespace

TEST_CASE("without a limit it finds the best path", "[task-1][best]") {
    for (const Scene& s : maps()) {
        const double right = best_cost(s);
        if (!(right < infinity)) continue;
        const Run yours = run(s, without_end);
        expect_outcome(s, without_end, yours.outcome, Outcome::found, "There is a path.");
        expect_near(
            legend(s) + "the cost of the path", yours.cost, right, 1e-9,
            "What is right was found without any list, by going over all edges until none made anything cheaper. "
            "The goal is found when it is taken from the open list: as long as it is only on it, a cheaper way "
            "may lead there.");
    }
    const Scene ferry{{{{1, 1}, {2, 10}}, {{2, 1}}, {}}, {2, 1, 0}, 0, 2, ""};
    expect_near("three nodes: from 0 to 2 for 10, from 0 to 1 for 1, and from 1 to 2 for 1; the cost of the path",
                run(ferry, without_end).cost, 2.0, 1e-9,
                "When node 0 is expanded, node 2 is put on the open list, for 10. It is not found yet: node 1 has the "
                "lesser f and is taken first.");
}

TEST_CASE("and expands nothing behind the goal", "[task-1][goal-ends-it]") {
    const Scene corridor = map_of({"S..G......"});
    expect_count(corridor.picture + "nodes on the closed list in the end", run(corridor, without_end).closed.size(), 4,
                 "When the goal is taken, all is done, whatever is left of the budget.");
}

TEST_CASE("where nothing is left on the open list, there is no path", "[task-1][no-path]") {
    for (const Scene& s : maps()) {
        if (best_cost(s) < infinity) continue;
        const Run yours = run(s, without_end);
        expect_outcome(s, without_end, yours.outcome, Outcome::no_path, "No way leads to G.");
        expect_count(legend(s) + "nodes that were expanded", yours.closed.size(), reachable(s),
                     "That there is no path is known when all that can be reached was expanded, and not before.");
    }
}

TEST_CASE("no call expands more nodes than it may", "[task-1][budget]") {
    for (const std::size_t most : {1, 2, 7, 30}) {
        const Scene s = castle(true);
        const std::size_t yours = run(s, most).most_in_a_call;
        expect(yours <= most, legend(s) + slices(most) +
                                  ", the most nodes that one call took from the open list\n    yours  " +
                                  std::to_string(yours) + "\n    right  " + std::to_string(most) +
                                  " or less\nA frame that takes longer than it may is what the budget is for.");
    }
}

TEST_CASE("in slices it is the same search, node by node", "[task-1][same-search]") {
    for (const Scene& s : maps())
        for (const std::size_t most : {1, 2, 7, 30}) {
            const Run at_once = run(s, without_end), sliced = run(s, most);
            expect_outcome(
                s, most, sliced.outcome, at_once.outcome,
                "That is what yours says in one call. With nothing lost between two calls, and nothing begun "
                "anew, slices come to the same. (Asked no more than 400 times.)");
            expect_count(legend(s) + slices(most) + ", nodes that were expanded", sliced.closed.size(),
                         at_once.closed.size(), "So many they are in one call.");
            expect(sliced.closed == at_once.closed, legend(s) + slices(most) +
                                                        ", yours expands other nodes than in one call.\nWhere the "
                                                        "search stops, the next call must go on.");
        }
}

TEST_CASE("it takes as many frames as the budget says", "[task-1][frames]") {
    for (const Scene& s : maps()) {
        const Run at_once = run(s, without_end);
        const bool found = best_cost(s) < infinity;
        const std::size_t expanded = at_once.closed.size() - found;
        for (const std::size_t most : {std::size_t(1), std::size_t(7), std::size_t(30), expanded}) {
            const std::size_t right = found ? expanded / most + 1 : (expanded + most - 1) / most;
            expect_count(legend(s) + slices(most) + ", with " + std::to_string(expanded) +
                             " nodes to expand in all; calls until it ends",
                         run(s, most).calls, right,
                         found ? "When the budget is used up, the goal is left for the next call."
                               : "When the open list is empty, it is known at once that there is no path, also where "
                                 "the budget has just been used up.");
        }
    }
}

TEST_CASE("the nearest is the one with the least h", "[task-2][least-h]") {
    expect_nearest(round_a_wall(), "h is the estimate of what is left to go. How far a node is from the start does not "
                                   "matter, nor when it was expanded.");
}

TEST_CASE("of several that are equally near the first one", "[task-2][first]") {
    expect_nearest(equally_near(), "Several have the same h. The one that was expanded first has been asked for.");
}

TEST_CASE("it may be the start", "[task-2][start]") {
    expect_nearest(start_is_nearest(), "Every step leads away. Who is as near as one can come stays.");
}

TEST_CASE("with a weight of 1 it is the f of A*", "[task-3][plain]") {
    for (const auto& [g, h] : {std::pair{3.0, 4.0}, {0.0, 2.5}, {7.5, 1.25}})
        expect_near("g = " + detail::shown(g) + ", h = " + detail::shown(h) + ", w = 1; f",
                    exercise::weighted_f(g, h, 1), g + h, 1e-12,
                    "f = g + h, the estimated cost of the whole way over this node.");
}

TEST_CASE("at the goal it is what the path costs", "[task-3][goal]") {
    for (const double w : {1.0, 1.5, 4.0})
        expect_near("g = 6, h = 0, w = " + detail::shown(w) + "; f", exercise::weighted_f(6, 0, w), 6.0, 1e-12,
                    "Nothing is estimated there any more, so that no weight can change it.");
}

TEST_CASE("the path costs at most w times the best", "[task-3][bound]") {
    for (const Scene& s : maps())
        for (const double w : {1.0, 1.2, 1.5, 2.0, 5.0}) {
            const double best = best_cost(s), yours = hasty(s, w).cost;
            std::ostringstream text;
            text << legend(s) << "w = " << w << "; the cost of the path\n    yours  " << yours << "\n    right  from "
                 << best << " to " << w * best
                 << "\nThat is what the weight promises as long as h is consistent (6.1.1), as it is here.";
            expect(!(best < infinity) || yours <= w * best + 1e-9, text.str());
        }
}

TEST_CASE("and it expands less", "[task-3][less]") {
    std::size_t plain = 0, with_weight = 0;
    for (const Scene& s : maps())
        if (best_cost(s) < infinity) plain += hasty(s, 1).looked_at, with_weight += hasty(s, 3).looked_at;
    expect(4 * with_weight <= 3 * plain,
           "nodes expanded, on all maps that have a path\n    yours, with w = 1  " + std::to_string(plain) +
               "\n    yours, with w = 3  " + std::to_string(with_weight) + "\n    right, with w = 3  " +
               std::to_string(3 * plain / 4) +
               " or less\nAn estimate that counts more draws the search to the goal: that is what the weight is for.");
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    if (task == 1)
        for (const Scene& s : maps())
            for (const std::size_t most : {std::size_t(1), std::size_t(7), without_end}) {
                const Run r = run(s, most);
                numbers.push_back(double(r.outcome)), numbers.push_back(double(r.calls));
                numbers.push_back(r.cost < infinity ? r.cost : -1);
                numbers.push_back(r.outcome == Outcome::no_path ? double(r.closed.size()) : 0);
            }
    if (task == 1) {
        numbers.push_back(double(run(map_of({"S..G......"}), without_end).closed.size()));
        const Scene s = castle(true);
        auto search = exercise::begin(s.graph, s.h, s.start, s.goal);
        for (const std::size_t most : {3, 5, 2}) {
            exercise::advance(search, most);
            numbers.push_back(double(search.closed.size()));
        }
    }
    if (task == 2)
        for (const auto& lists : {round_a_wall(), equally_near(), start_is_nearest()})
            for (const auto& list : lists) numbers.push_back(double(exercise::nearest(list)));
    if (task == 3)
        for (const double w : {1.0, 1.5, 2.25, 4.0})
            for (const auto& [g, h] : {std::pair{3.0, 4.0}, {0.0, 2.5}, {7.5, 1.25}, {6.0, 0.0}})
                numbers.push_back(exercise::weighted_f(g, h, w));
    return numbers;
}
