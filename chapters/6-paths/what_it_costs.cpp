// SPDX-License-Identifier: BSL-1.0
// What accuracy costs in chapter 6: heuristics and their weight, the number that costs are, jump points, and what a
// planner estimates with

// Read the rows like this. In "heuristic" an error of zero is the best path, and the rows that have it differ only in
// the nodes they expand; Weighted gives a little of the path's length away for most of the work, up to a weight of 1.5
// or 2, and nothing more beyond. In "cost number" all paths are equally good; the error is how far the cost that the
// search reports is off the length of its path, and the work shows what ties do: sums in floating point differ in the
// last digit for paths of one length, so that a search follows both. In "planner" the error is what a plan costs too
// much.
//
// Every row is the mean of the same queries. Each search is warm: what it allocates it allocated before.

#include "what_it_costs.hpp"

#include <ansatz/paths/a_star.hpp>
#include <ansatz/paths/boost_a_star.hpp>
#include <ansatz/paths/buckets.hpp>
#include <ansatz/paths/goap.hpp>
#include <ansatz/paths/grid/graph.hpp>
#include <ansatz/paths/grid/jump_points.hpp>
#include <ansatz/paths/heuristics.hpp>

#include <cmath>
#include <cstdint>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

using namespace path_costs;

namespace {

/// Queries from the left quarter of a map to its right one.
ScenePointer scene(std::string name, Grid<> map, std::uint32_t seed) {
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

} // namespace

/// Every fifth tile is blocked.
ScenePointer path_costs::stones() {
    Grid<> map(128, 128);
    std::mt19937 random(1);
    for (std::uint16_t y = 0; y < 128; ++y)
        for (std::uint16_t x = 0; x < 128; ++x) map.set_passable(Cell{x, y}, random() % 5 != 0);
    return scene("128 x 128 tiles, 20 % blocked", std::move(map), 2);
}
/// Open ground with blocks of 8 x 8 tiles here and there.
ScenePointer path_costs::blocks() {
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
ScenePointer path_costs::rooms() {
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

namespace {

void add_heuristics(Costs& costs, const ScenePointer& scene) {
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

void add_numbers(Costs& costs, const ScenePointer& scene) {
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

void add_successors(Costs& costs, const ScenePointer& scene) {
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

/// A workshop of several chairs: most actions satisfy one fact, one satisfies three at once.
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
    d.action("clean", 0.5).makes(clean);
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
    for (const auto& scene : {stones(), rooms()}) add_goals(costs, scene);
    for (const auto& scene : {stones(), rooms(), blocks()}) add_any_angle(costs, scene);
    for (const std::size_t side : {128, 256, 512}) add_hierarchy(costs, side);
    for (const std::size_t agents : {2, 4, 6}) add_agents(costs, agents, 20);
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
