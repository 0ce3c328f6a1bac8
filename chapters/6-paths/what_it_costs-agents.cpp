// SPDX-License-Identifier: BSL-1.0
// What it costs that agents do not meet: one after the other, a window ahead, or all together

// Crowds on 8 x 8 tiles, a tenth blocked, that all three methods bring to their goals: the ones that a method cannot
// solve have no error. The error is held against all together, which is the best there is.

#include "what_it_costs.hpp"

#include <ansatz/paths/conflict_based.hpp>
#include <ansatz/paths/prioritised.hpp>
#include <ansatz/paths/windowed.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <span>

using namespace path_costs;

namespace {

struct Crowd {
    Grid<> map{8, 8};
    std::vector<Errand> errands;
    double best = 0; // tiles, of all together
};
/// What agents walk on their ways, tiles: waiting counts as a step, as in all plans, until an agent stands for good.
struct Walked {
    double tiles = 0;
    std::size_t expanded = 0;
    bool solved = false;
};
double tiles_of(std::span<const Cell> plan) {
    double tiles = 0;
    for (std::size_t s = 1; s < plan.size(); ++s)
        tiles += plan[s].x != plan[s - 1].x && plan[s].y != plan[s - 1].y ? std::sqrt(2.0) : 1.0;
    return tiles;
}

Walked by_ranks(const Crowd& crowd) {
    Prioritised plans{crowd.map};
    Walked all;
    all.solved = plans.find(crowd.errands);
    all.expanded = plans.expanded();
    for (std::size_t k = 0; all.solved && k < crowd.errands.size(); ++k) all.tiles += tiles_of(plans.plan(k));
    return all;
}
Walked by_window(const Crowd& crowd) {
    Windowed plans{crowd.map, 16};
    plans.begin(crowd.errands);
    std::vector<std::vector<Cell>> ways(crowd.errands.size());
    for (int step = 0; step < 200 && !plans.all_arrived(); ++step) {
        for (std::size_t k = 0; k < ways.size(); ++k) ways[k].push_back(plans.at(k));
        plans.step();
    }
    Walked all{0, plans.expanded(), plans.all_arrived()};
    for (std::size_t k = 0; k < ways.size(); ++k) {
        auto& way = ways[k];
        while (!way.empty() && way.back() == crowd.errands[k].goal) way.pop_back(); // stands for good
        way.push_back(crowd.errands[k].goal);
        all.tiles += tiles_of(way);
    }
    return all;
}
Walked together(const Crowd& crowd) {
    ConflictBased plans{crowd.map};
    const bool solved = plans.find(crowd.errands, 2000) == paths::Outcome::found;
    return {solved ? plans.tiles() : 0, plans.expanded(), solved};
}

Crowd any_crowd(std::mt19937& random, std::size_t agents) {
    const auto cell = [&] { return Cell{std::uint16_t(random() % 8), std::uint16_t(random() % 8)}; };
    Crowd crowd;
    for (int i = 0; i < 6; ++i) crowd.map.set_passable(cell(), false);
    while (crowd.errands.size() < agents) {
        const Errand one{cell(), cell()};
        const bool taken = std::any_of(crowd.errands.begin(), crowd.errands.end(), [&](const Errand& other) {
            return other.start == one.start || other.goal == one.goal;
        });
        AStar alone{crowd.map};
        if (!taken && alone.find(one.start, one.goal) == paths::Outcome::found) crowd.errands.push_back(one);
    }
    return crowd;
}

} // namespace

void path_costs::add_agents(Costs& costs, std::size_t agents, int crowds) {
    const Axis axis{.name = "several agents",
                    .error_norm = "mean of steps of all / fewest steps - 1",
                    .work_unit = "nodes expanded",
                    .time_unit = "ns per crowd",
                    .has_order = false};
    const auto all = std::make_shared<std::vector<Crowd>>();
    std::mt19937 random(11);
    while (int(all->size()) < crowds) {
        Crowd crowd = any_crowd(random, agents);
        const Walked best = together(crowd);
        if (!best.solved || !by_ranks(crowd).solved || !by_window(crowd).solved) continue;
        crowd.best = best.tiles;
        all->push_back(std::move(crowd));
    }
    const auto add = [&](std::string choice, Walked (*walk)(const Crowd&)) {
        costs.add(axis, {.choice = std::move(choice),
                         .problem = "8 x 8 tiles, 10 % blocked",
                         .parameter = {"agents", double(agents)},
                         .n = int(agents),
                         .error_run =
                             [=] {
                                 Judged sum;
                                 for (const Crowd& crowd : *all) {
                                     const Walked found = walk(crowd);
                                     sum.error += (found.tiles / crowd.best - 1) / crowds;
                                     sum.work += double(found.expanded) / crowds;
                                 }
                                 return workbook::Outcome{.error = sum.error, .work = sum.work};
                             },
                         .timed_run =
                             [=] {
                                 std::size_t sum = 0;
                                 for (const Crowd& crowd : *all) sum += walk(crowd).expanded;
                                 return sum;
                             },
                         .per = double(crowds)});
    };
    add("Prioritised", by_ranks);
    add("Windowed", by_window);
    add("ConflictBased", together);
}
