// SPDX-License-Identifier: BSL-1.0
// What a path costs that does not turn by 45 degrees, and one that is found from gate to gate of a large map

// No program here knows the shortest path of any angle. The error is held against the shorter of two good ones, that of
// AnyAngle; that one is the reference, not the truth.

#include "rooms.hpp"
#include "what_it_costs.hpp"

#include <ansatz/paths/any_angle.hpp>
#include <ansatz/paths/buckets.hpp>
#include <ansatz/paths/gate_search.hpp>
#include <ansatz/paths/lazy_theta.hpp>
#include <ansatz/paths/smoothing.hpp>

#include <random>

using namespace path_costs;

void path_costs::add_any_angle(Costs& costs, const ScenePointer& scene) {
    const Axis axis{.name = "any angle",
                    .error_norm = "mean of path / path of AnyAngle - 1",
                    .work_unit = "nodes expanded",
                    .time_unit = "ns per query",
                    .has_order = false};
    const auto tiles = std::make_shared<AStar<Grid<>, Octile, Buckets>>(scene->map, Octile{}, Buckets{});
    const auto theta = std::make_shared<AStar<Grid<>, LazyTheta>>(scene->map, LazyTheta{});
    const auto both = std::make_shared<AnyAngle<Grid<>, Buckets>>(scene->map, Buckets{});
    struct Walk {
        double length; // tiles
        std::size_t expanded;
    };
    const auto add = [&](std::string choice, auto walk) {
        costs.add(axis, {.choice = std::move(choice),
                         .problem = scene->name,
                         .parameter = {},
                         .n = int(scene->map.size()),
                         .error_run =
                             [=] {
                                 return mean_of(*scene, [&](const Query& q) {
                                     const Walk found = walk(q);
                                     both->find(q.start, q.goal);
                                     return Judged{.error = found.length / both->tiles() - 1,
                                                   .work = double(found.expanded)};
                                 });
                             },
                         .timed_run =
                             [=] {
                                 double sum = 0;
                                 for (const Query& q : scene->queries) sum += walk(q).length;
                                 return sum;
                             },
                         .per = double(scene->queries.size())});
    };
    add("along the tiles", [=](const Query& q) {
        tiles->find(q.start, q.goal);
        return Walk{scene->map.tiles(tiles->path()), tiles->expanded()};
    });
    add("smooth", [=](const Query& q) {
        tiles->find(q.start, q.goal);
        return Walk{straight_tiles(smooth(scene->map, tiles->path())), tiles->expanded()};
    });
    add("LazyTheta", [=](const Query& q) {
        theta->find(q.start, q.goal);
        return Walk{straight_tiles(theta->path()), theta->expanded()};
    });
    add("AnyAngle", [=](const Query& q) {
        both->find(q.start, q.goal);
        return Walk{both->tiles(), both->a_star().expanded() + both->theta().expanded()};
    });
}

void path_costs::add_hierarchy(Costs& costs, std::size_t side) {
    const Axis axis{.name = "hierarchy",
                    .error_norm = "mean of path / best path - 1",
                    .work_unit = "nodes expanded",
                    .time_unit = "ns per query",
                    .has_order = false};
    const std::string name = std::to_string(side) + " x " + std::to_string(side) + " tiles, rooms of 12 x 12";
    std::mt19937 of_map(7), random(8);
    const auto scene = std::make_shared<Scene>(Scene{name, rooms_with_doors(side, of_map), {}});
    AStar best{scene->map, Octile{}};
    const auto quarter = std::uint32_t(side / 4);
    while (scene->queries.size() < 12) {
        const Cell start{std::uint16_t(random() % quarter), std::uint16_t(random() % side)},
            goal{std::uint16_t(3 * quarter + random() % quarter), std::uint16_t(random() % side)};
        if (best.find(start, goal) == paths::Outcome::found)
            scene->queries.push_back({start, goal, scene->map.tiles(best.path())});
    }
    add_row(costs, axis, scene, "Heap", {}, longer, Octile{}, Heap{});
    add_row(costs, axis, scene, "Buckets", {}, longer, Octile{}, Buckets{});
    for (const bool improves : {true, false}) {
        const auto gates = std::make_shared<GateSearch<Grid<>>>(scene->map);
        gates->improves = improves;
        costs.add(axis, {.choice = improves ? "GateSearch" : "GateSearch, not improved",
                         .problem = scene->name,
                         .parameter = {},
                         .n = int(scene->map.size()),
                         .error_run =
                             [=] {
                                 return mean_of(*scene, [&](const Query& q) {
                                     gates->find(q.start, q.goal);
                                     return Judged{.error = scene->map.tiles(gates->path()) / q.best - 1,
                                                   .work = double(gates->expanded())};
                                 });
                             },
                         .timed_run =
                             [=] {
                                 std::size_t sum = 0;
                                 for (const Query& q : scene->queries)
                                     gates->find(q.start, q.goal), sum += gates->path().size();
                                 return sum;
                             },
                         .per = double(scene->queries.size())});
    }
    // Once for a map, and again for the squares that change.
    costs.add(axis, {.choice = "GateSearch, its gates",
                     .problem = scene->name,
                     .parameter = {},
                     .n = int(scene->map.size()),
                     .error_run = [=] { return workbook::Outcome{.error = 0, .work = double(scene->map.size())}; },
                     .timed_run = [=] { return Clusters<Grid<>>(scene->map).squares(); }});
}
