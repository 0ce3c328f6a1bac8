// SPDX-License-Identifier: BSL-1.0
// What is shared among many: one field for a crowd with one goal, and one search for the nearest of several goals

#include "what_it_costs.hpp"

#include <ansatz/paths/buckets.hpp>
#include <ansatz/paths/flow_field.hpp>
#include <ansatz/paths/goals.hpp>
#include <ansatz/paths/true_costs.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

using namespace path_costs;

/// So many walkers from anywhere to the goal of the scene's first query: a search for each, and one field for all.
void path_costs::add_crowds(Costs& costs, const ScenePointer& scene) {
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

/// The nearest of so many goals: a search to each, or one that ends at whichever comes first.
void path_costs::add_goals(Costs& costs, const ScenePointer& scene) {
    const Axis axis{.name = "nearest goal",
                    .error_norm = "mean of path / path to the nearest - 1",
                    .work_unit = "nodes expanded",
                    .time_unit = "ns per query",
                    .has_order = false};
    using Each = AStar<Grid<>, Octile, Buckets>;
    using Any = AStar<Grid<>, AnyGoal, Octile, Buckets>;
    std::mt19937 random(9);
    for (const std::size_t count : {2, 4, 8, 16, 32}) {
        // Among the tiles that are reached from the first start, so that each goal is.
        auto goals = std::make_shared<std::vector<Cell>>();
        const auto costs_to = true_costs<std::uint32_t>(scene->map, scene->queries.front().start);
        while (goals->size() < count) {
            const Cell c{std::uint16_t(random() % scene->map.width()), std::uint16_t(random() % scene->map.height())};
            if (costs_to[scene->map.index(c)] < paths::detail::infinite<std::uint32_t>) goals->push_back(c);
        }
        const auto each = std::make_shared<Each>(scene->map, Octile{}, Buckets{});
        const auto any = std::make_shared<Any>(scene->map, AnyGoal{}, Octile{}, Buckets{});
        struct Nearest {
            std::uint32_t cost;
            std::size_t expanded;
        };
        const auto by_each = [=](Cell start) {
            Nearest found{paths::detail::infinite<std::uint32_t>, 0};
            for (const Cell goal : *goals) {
                each->find(start, goal);
                found.cost = std::min(found.cost, each->cost());
                found.expanded += each->expanded();
            }
            return found;
        };
        const auto by_any = [=](Cell start) {
            any->find(start, *goals);
            return Nearest{any->cost(), any->expanded()};
        };
        const auto add = [&](std::string choice, auto search) {
            costs.add(axis, {.choice = std::move(choice),
                             .problem = scene->name,
                             .parameter = {"goals", double(count)},
                             .n = int(count),
                             .error_run =
                                 [=] {
                                     return mean_of(*scene, [&](const Query& q) {
                                         const auto found = search(q.start);
                                         const auto best = by_each(q.start).cost; // 0 where a goal is the start
                                         const double off = found.cost == best ? 0 : double(found.cost) / best - 1;
                                         return Judged{.error = off, .work = double(found.expanded)};
                                     });
                                 },
                             .timed_run =
                                 [=] {
                                     std::size_t sum = 0;
                                     for (const Query& q : scene->queries) sum += search(q.start).expanded;
                                     return sum;
                                 },
                             .per = double(scene->queries.size())});
        };
        add("a search each", by_each);
        add("AnyGoal", by_any);
    }
}
