// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What `what_it_costs` of chapter 6 is made of: maps with queries, a row for a search, and the axes that have a file
/// of their own.

#include "costs.hpp"

#include <ansatz/paths/a_star.hpp>
#include <ansatz/paths/grid/graph.hpp>
#include <ansatz/paths/heuristics.hpp>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace path_costs {

using namespace ansatz;
using namespace ansatz::paths;
using workbook::Axis;
using workbook::Costs;

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

using ScenePointer = std::shared_ptr<const Scene>;

ScenePointer stones(); ///< 128 x 128 tiles, every fifth blocked
ScenePointer rooms();  ///< rooms of 15 x 15 tiles with a door in each wall
ScenePointer blocks(); ///< open ground with blocks of 8 x 8 tiles here and there

void add_crowds(Costs& costs, const ScenePointer& scene);      ///< one field or many searches
void add_goals(Costs& costs, const ScenePointer& scene);       ///< the nearest of several goals
void add_any_angle(Costs& costs, const ScenePointer& scene);   ///< paths that do not turn by 45 degrees
void add_hierarchy(Costs& costs, std::size_t side);            ///< from gate to gate of a large map
void add_agents(Costs& costs, std::size_t agents, int crowds); ///< several who must not meet

/// An answer: what is wrong with it, and what was expanded.
struct Judged {
    double error = 0, work = 0;
};
/// The mean of what is wrong with the answers to all queries of a scene, and of what was expanded.
/// \param answer makes the search: answer(query) -> {error, work}
template <class Answer> workbook::Outcome mean_of(const Scene& scene, Answer&& answer) {
    Judged sum;
    const double n = double(scene.queries.size());
    for (const Query& q : scene.queries) {
        const Judged one = answer(q);
        sum.error += one.error / n;
        sum.work += one.work / n;
    }
    return workbook::Outcome{.error = sum.error, .work = sum.work};
}

/// One row: all queries of a scene by one search.
/// \param error_of what is wrong with the answer to a query: error_of(search, query)
template <class Error, class... Policies>
void add_row(Costs& costs, const Axis& axis, const ScenePointer& scene, std::string choice,
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

} // namespace path_costs
