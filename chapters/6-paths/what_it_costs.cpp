// SPDX-License-Identifier: BSL-1.0
// What accuracy costs in chapter 6: heuristics and their weight, the number that costs are, jump points, a field for
// many, and what a planner estimates with

// Read the rows like this. In "heuristic" an error of zero is the best path, and the rows that have it differ only in
// what they look at; Weighted gives a little of the path's length away for most of the work, up to a weight of 1.5 or
// 2, and nothing more beyond. In "cost number" all paths are equally good; the error is how far the cost that the
// search reports is off the length of its path, and the work shows what ties do: sums in floating point differ in the
// last digit for paths of one length, so that a search looks at both. In "planner" the error is what a plan costs too
// much.
//
// Every row is the mean of the same queries. Each search is warm: what it allocates it allocated before.

#include "costs.hpp"

#include <ansatz/paths/a_star.hpp>
#include <ansatz/paths/boost_a_star.hpp>
#include <ansatz/paths/buckets.hpp>
#include <ansatz/paths/flow_field.hpp>
#include <ansatz/paths/goap.hpp>
#include <ansatz/paths/grid/graph.hpp>
#include <ansatz/paths/grid/jump_points.hpp>
#include <ansatz/paths/heuristics.hpp>
#include <ansatz/paths/true_costs.hpp>

#include <cmath>
#include <cstdint>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

using namespace ansatz;
using namespace ansatz::paths;
using workbook::Axis;
using workbook::Costs;

namespace {

struct Query {
    Cell start, goal;
    double best = 0; ///< the length of the best path, tiles
};
/// A map and queries on it, each of which has a path.
struct Scene {
    std::string name;
    Grid<> map;
    std::vector<Query> queries;
};

/// Queries from the left quarter of a map to its right one.
std::shared_ptr<const Scene> scene(std::string name, Grid<> map, std::uint32_t seed) {
    auto made = std::make_shared<Scene>(Scene{std::move(name), std::move(map), {}});
    std::mt19937 random(seed);
    AStar search{made->map, Octile{}};
    const auto quarter = std::uint32_t(made->map.width() / 4);
    while (made->queries.size() < 24) {
        const Cell start{std::uint16_t(random() % quarter), std::uint16_t(random() % made->map.height())},
            goal{std::uint16_t(3 * quarter + random() % quarter), std::uint16_t(random() % made->map.height())};
        if (search.find(start, goal) == paths::Outcome::found)
            made->queries.push_back({start, goal, made->map.tiles(search.path())});
    }
    return made;
}
/// Every fifth tile is blocked.
std::shared_ptr<const Scene> stones() {
    Grid<> map(128, 128);
    std::mt19937 random(1);
    for (std::uint16_t y = 0; y < 128; ++y)
        for (std::uint16_t x = 0; x < 128; ++x) map.set_passable(Cell{x, y}, random() % 5 != 0);
    return scene("128 x 128 tiles, 20 % blocked", std::move(map), 2);
}
/// Open ground with blocks of 8 x 8 tiles here and there.
std::shared_ptr<const Scene> blocks() {
    Grid<> map(256, 256);
    std::mt19937 random(5);
    for (int block = 0; block < 100; ++block) {
        const auto left = std::uint16_t(random() % 248), top = std::uint16_t(random() % 248);
        for (std::uint16_t y = top; y < top + 8; ++y)
            for (std::uint16_t x = left; x < left + 8; ++x) map.set_passable(Cell{x, y}, false);
    }
    return scene("256 x 256 tiles, blocks of 8 x 8", std::move(map), 6);
}
/// Rooms of 15 x 15 tiles with a door in each wall.
std::shared_ptr<const Scene> rooms() {
    Grid<> map(128, 128);
    std::mt19937 random(3);
    for (std::uint16_t y = 0; y < 128; ++y)
        for (std::uint16_t x = 0; x < 128; ++x) map.set_passable(Cell{x, y}, x % 16 != 15 && y % 16 != 15);
    for (std::uint16_t room_y = 0; room_y < 8; ++room_y)
        for (std::uint16_t room_x = 0; room_x < 8; ++room_x) {
            const auto along = std::uint16_t(1 + random() % 13), down = std::uint16_t(1 + random() % 13);
            map.set_passable(Cell{std::uint16_t(16 * room_x + 15), std::uint16_t(16 * room_y + down)}, true);
            map.set_passable(Cell{std::uint16_t(16 * room_x + along), std::uint16_t(16 * room_y + 15)}, true);
        }
    return scene("128 x 128 tiles, rooms", std::move(map), 4);
}

/// One row: all queries of a scene by one search.
/// \param error_of what is wrong with the answer to a query: error_of(search, query)
template <class Error, class... Policies>
void add_row(Costs& costs, const Axis& axis, const std::shared_ptr<const Scene>& scene, std::string choice,
             workbook::Parameter parameter, Error error_of, Policies... policies) {
    using Search = AStar<Grid<>, Policies...>;
    auto search = std::make_shared<Search>(scene->map, policies...);
    costs.add(axis, {.choice = std::move(choice),
                     .problem = scene->name,
                     .parameter = std::move(parameter),
                     .n = int(scene->map.size()),
                     .error_run =
                         [=] {
                             double error = 0, work = 0;
                             for (const Query& q : scene->queries) {
                                 search->find(q.start, q.goal);
                                 error += error_of(*search, q);
                                 work += double(search->expanded());
                             }
                             const double n = double(scene->queries.size());
                             return workbook::Outcome{.error = error / n, .work = work / n};
                         },
                     .timed_run =
                         [=] {
                             std::size_t expanded = 0;
                             for (const Query& q : scene->queries) {
                                 search->find(q.start, q.goal);
                                 expanded += search->expanded();
                             }
                             return expanded;
                         },
                     .per = double(scene->queries.size())});
}

/// By how much a path is longer than the best. Both lengths are sums of straight and of diagonal steps; below 1e-12
/// they are the same.
constexpr auto longer = [](const auto& search, const Query& q) {
    const double too_long = search.graph().tiles(search.path()) / q.best - 1;
    return too_long < 1e-12 ? 0 : too_long;
};

void add_heuristics(Costs& costs, const std::shared_ptr<const Scene>& scene) {
    const Axis axis{.name = "heuristic",
                    .error_norm = "mean of path / best path - 1",
                    .work_unit = "nodes expanded",
                    .time_unit = "ns per query",
                    .has_order = false};
    add_row(costs, axis, scene, "ZeroHeuristic", {}, longer, ZeroHeuristic{});
    add_row(costs, axis, scene, "Chebyshev", {}, longer, Chebyshev{});
    add_row(costs, axis, scene, "Euclid", {}, longer, Euclid{});
    add_row(costs, axis, scene, "Octile", {}, longer, Octile{});
    for (const std::size_t count : {4, 16})
        add_row(costs, axis, scene, "Maximum<Octile, Landmarks>", {"landmarks", count}, longer,
                Maximum{Octile{}, Landmarks<std::uint32_t>(scene->map, count)});
    add_row(costs, axis, scene, "Manhattan", {}, longer, Manhattan{}, NoReopening{});
    for (const double w : {1.05, 1.1, 1.2, 1.5, 2.0, 3.0, 5.0})
        add_row(costs, axis, scene, "Weighted<Octile>", {"w", w}, longer, Weighted{Octile{}, w}, NoReopening{});
    for (const double w : {1.2, 2.0})
        add_row(costs, axis, scene, "Weighted<Octile>, Reopening", {"w", w}, longer, Weighted{Octile{}, w});
}

void add_numbers(Costs& costs, const std::shared_ptr<const Scene>& scene) {
    const Axis axis{.name = "cost number",
                    .error_norm = "mean of |cost / length of its path - 1|",
                    .work_unit = "nodes expanded",
                    .time_unit = "ns per query",
                    .has_order = false};
    auto off = [](const auto& search, const Query&) {
        using Cost = std::decay_t<decltype(search.cost())>;
        const double tiles = double(search.cost()) / double(Tile<Cost>::straight);
        return std::abs(tiles / search.graph().tiles(search.path()) - 1);
    };
    add_row(costs, axis, scene, "Heap, uint32", {}, off, Octile{}, Heap{}, CostIn<std::uint32_t>{});
    add_row(costs, axis, scene, "Heap, uint64", {}, off, Octile{}, Heap{}, CostIn<std::uint64_t>{});
    add_row(costs, axis, scene, "Heap, float", {}, off, Octile{}, Heap{}, CostIn<float>{});
    add_row(costs, axis, scene, "Heap, double", {}, off, Octile{}, Heap{}, CostIn<double>{});
    add_row(costs, axis, scene, "Buckets, uint32", {}, off, Octile{}, Buckets{}, CostIn<std::uint32_t>{});
    add_row(costs, axis, scene, "boost::astar_search, uint32", {}, off, Octile{}, BoostAStar{},
            CostIn<std::uint32_t>{});
    add_row(costs, axis, scene, "boost::astar_search, double", {}, off, Octile{}, BoostAStar{}, CostIn<double>{});
}

void add_successors(Costs& costs, const std::shared_ptr<const Scene>& scene) {
    const Axis axis{.name = "successors",
                    .error_norm = "mean of path / best path - 1",
                    .work_unit = "nodes expanded",
                    .time_unit = "ns per query",
                    .has_order = false};
    add_row(costs, axis, scene, "EveryEdge, Heap", {}, longer, Octile{}, EveryEdge{}, Heap{});
    add_row(costs, axis, scene, "EveryEdge, Buckets", {}, longer, Octile{}, EveryEdge{}, Buckets{});
    add_row(costs, axis, scene, "JumpPoints, Heap", {}, longer, Octile{}, JumpPoints{}, Heap{});
    add_row(costs, axis, scene, "JumpPoints, Buckets", {}, longer, Octile{}, JumpPoints{}, Buckets{});
}

/// So many walkers from anywhere to the goal of the scene's first query: a search for each, and one field for all.
void add_crowds(Costs& costs, const std::shared_ptr<const Scene>& scene) {
    const Axis axis{.name = "crowd",
                    .error_norm = "mean of path / best path - 1",
                    .work_unit = "nodes expanded, by all together",
                    .time_unit = "ns for all together",
                    .has_order = false};
    using Search = AStar<Grid<>, Octile, Buckets>;
    using Field = FlowField<Grid<>, Buckets>;
    const Cell goal = scene->queries.front().goal;
    const auto costs_to = true_costs<std::uint32_t>(scene->map, goal);
    for (const int walkers : {1, 3, 10, 30, 100, 1000}) {
        auto from = std::make_shared<std::vector<Cell>>();
        std::mt19937 random(5);
        while (int(from->size()) < walkers) {
            const Cell c{std::uint16_t(random() % scene->map.width()), std::uint16_t(random() % scene->map.height())};
            if (costs_to[scene->map.index(c)] < paths::detail::infinite<std::uint32_t>) from->push_back(c);
        }
        const auto search = std::make_shared<Search>(scene->map, Octile{}, Buckets{});
        const auto field = std::make_shared<Field>(scene->map, Buckets{});
        const auto off = [=](Cell c, std::uint32_t cost) {
            const auto best = costs_to[scene->map.index(c)];
            return best == 0 ? 0.0 : std::abs(double(cost) / best - 1);
        };
        costs.add(axis, {.choice = "a search each",
                         .problem = scene->name,
                         .parameter = {"walkers", double(walkers)},
                         .n = walkers,
                         .error_run =
                             [=] {
                                 double error = 0, work = 0;
                                 for (const Cell c : *from) {
                                     search->find(c, goal);
                                     error += off(c, search->cost()) / walkers;
                                     work += double(search->expanded());
                                 }
                                 return workbook::Outcome{.error = error, .work = work};
                             },
                         .timed_run =
                             [=] {
                                 std::size_t steps = 0;
                                 for (const Cell c : *from) search->find(c, goal), steps += search->path().size();
                                 return steps;
                             }});
        costs.add(axis, {.choice = "FlowField",
                         .problem = scene->name,
                         .parameter = {"walkers", double(walkers)},
                         .n = walkers,
                         .error_run =
                             [=] {
                                 field->aim(goal);
                                 double error = 0;
                                 for (const Cell c : *from) error += off(c, field->cost(c)) / walkers;
                                 return workbook::Outcome{.error = error, .work = double(field->expanded())};
                             },
                         .timed_run =
                             [=] {
                                 field->aim(goal);
                                 std::size_t steps = 0;
                                 for (const Cell c : *from) steps += field->next(c).x;
                                 return steps;
                             }});
    }
}

/// A workshop of several chairs: most actions settle one fact, one settles three at once.
struct Workshop {
    goap::Domain<> domain;
    goap::State<> start;
    goap::Condition<> goal;
};
std::shared_ptr<const Workshop> workshop(int chairs) {
    auto made = std::make_shared<Workshop>();
    auto& d = made->domain;
    const auto tools = d.fact("tools"), wood = d.fact("wood"), clean = d.fact("clean");
    std::vector<goap::Fact> wanted{clean};
    d.action("fetch tools", 2).makes(tools);
    d.action("fetch wood", 3).makes(wood, !clean);
    d.action("sweep", 0.5).makes(clean);
    for (int i = 0; i < chairs; ++i) {
        const std::string n = " " + std::to_string(i);
        const auto seat = d.fact("seat" + n), legs = d.fact("legs" + n), chair = d.fact("chair" + n),
                   painted = d.fact("painted" + n);
        wanted.insert(wanted.end(), {chair, painted});
        d.action("saw a seat" + n, 0.5).needs(tools, wood).makes(seat, !clean);
        d.action("turn legs" + n, 1).needs(tools, wood).makes(legs, !clean);
        d.action("join" + n, 0.5).needs(seat, legs).makes(chair, !seat, !legs);
        d.action("paint" + n, 0.5).needs(chair).makes(painted, !clean);
        d.action("buy" + n, 4 + 0.5 * i).makes(chair, painted);
    }
    goap::Condition<> goal;
    for (const auto fact : wanted) goal.care.set(fact.number, true), goal.value.set(fact.number, true);
    made->goal = goal;
    return made;
}
template <class Heuristic>
void add_planner(Costs& costs, const Axis& axis, const std::shared_ptr<const Workshop>& shop, int chairs,
                 std::string choice, Heuristic heuristic) {
    using Planner = goap::Planner<goap::Domain<>, Heuristic>;
    auto planner = std::make_shared<Planner>(shop->domain, heuristic);
    costs.add(axis, {.choice = std::move(choice),
                     .problem = "a workshop of " + std::to_string(chairs) + " chairs",
                     .parameter = {},
                     .n = int(shop->domain.facts()),
                     .error_run =
                         [=] {
                             goap::Planner best{shop->domain, ZeroHeuristic{}};
                             best.plan(shop->start, shop->goal);
                             planner->plan(shop->start, shop->goal);
                             return workbook::Outcome{.error = std::abs(planner->cost() / best.cost() - 1),
                                                      .work = double(planner->expanded())};
                         },
                     .timed_run = [=] { return planner->plan(shop->start, shop->goal); }});
}

} // namespace

int main(int argc, char** argv) {
    Costs costs("paths", argc, argv);
    for (const auto& scene : {stones(), rooms()}) add_heuristics(costs, scene);
    for (const auto& scene : {stones(), rooms()}) add_numbers(costs, scene);
    for (const auto& scene : {stones(), rooms(), blocks()}) add_successors(costs, scene);
    for (const auto& scene : {stones(), rooms()}) add_crowds(costs, scene);
    const Axis planner{.name = "planner",
                       .error_norm = "plan / cheapest plan - 1",
                       .work_unit = "states expanded",
                       .time_unit = "ns per plan",
                       .has_order = false};
    for (const int chairs : {2, 3}) {
        const auto shop = workshop(chairs);
        add_planner(costs, planner, shop, chairs, "ZeroHeuristic", ZeroHeuristic{});
        add_planner(costs, planner, shop, chairs, "Careful", goap::Careful{});
        add_planner(costs, planner, shop, chairs, "Greedy", goap::Greedy{});
    }
    return costs.run();
}
