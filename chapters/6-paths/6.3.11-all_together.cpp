// SPDX-License-Identifier: BSL-1.0
// 6.3.11 All together: the best plans for several, what they cost to find, and a crowd that plans a window ahead

// Ranks are quick and sometimes find nothing (6.3.10). Conflict-based search has no ranks: it plans everybody alone,
// finds two that meet, and tries both, the one giving way or the other. What it finds first costs the least that is
// possible for all together. Its price grows with the number of meetings, exponentially; so it is what a few are
// planned with, and what other methods are held against. The other way out is to plan less: a few steps ahead, and
// again before they are walked. (A part of section 6.3, beyond the notes.)

#include "claims.hpp"
#include "columns.hpp"
#include "crowd_film.hpp"
#include "say.hpp"

#include <ansatz/paths.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iomanip>
#include <iostream>
#include <random>
#include <string>
#include <vector>

using namespace ansatz;
using namespace ansatz::paths;

namespace {

/// A square of 8 x 8 tiles, a tenth blocked, and agents who can all get to their goals.
std::vector<Errand> crowd(Grid<>& square, std::mt19937& random, std::size_t n) {
    const auto cell = [&] { return Cell{std::uint16_t(random() % 8), std::uint16_t(random() % 8)}; };
    for (int i = 0; i < 6; ++i) square.set_passable(cell(), false);
    std::vector<Errand> errands;
    while (errands.size() < n) {
        const Errand one{cell(), cell()};
        const bool taken = std::any_of(errands.begin(), errands.end(), [&](const Errand& other) {
            return other.start == one.start || other.goal == one.goal;
        });
        AStar alone{square};
        if (!taken && alone.find(one.start, one.goal) == Outcome::found) errands.push_back(one);
    }
    return errands;
}

/// A film of the crowd below: each by its own best path, and by plans of 16 steps.
void draw(const Grid<>& square, const std::vector<Errand>& errands) {
    drawing::Crowd alone{"each for itself", {}}, planned{"16 steps ahead", {}};
    Windowed team{square, 16};
    team.begin(errands);
    for (const Errand& errand : errands) {
        AStar search{square};
        search.find(errand.start, errand.goal);
        alone.agents.emplace_back(search.path().begin(), search.path().end());
        planned.agents.push_back({errand.start});
    }
    while (!team.all_arrived()) {
        team.step();
        for (std::size_t i = 0; i < errands.size(); ++i) planned.agents[i].push_back(team.at(i));
    }
    workbook::Film film(
        "6.3.11", "Sixteen agents, each to the small dot of its colour",
        "Sixteen agents walk over a map of 8 x 8 tiles to their goals. On the left each takes its own "
        "best path, and again and again two are in one tile. On the right they are planned together: "
        "some wait or make way, nobody meets anybody, and all arrive.",
        {.middle = metres(0, 0.5, 0), .width = workbook::Film::wide / 60.0 * metre, .height = 9.6 * metre});
    drawing::walk_side_by_side(film.rate(12).hold(24), square, {alone, planned});
    film.write();
}

} // namespace

int main() {
    workbook::Claims claim;

    // The corridor of which no order has a plan.
    const auto corridor = grid_from<Grid<Four>>({"####.####", ".........", "#########"});
    const std::array<Errand, 2> errands{Errand{{0, 1}, {8, 1}}, Errand{{8, 1}, {0, 1}}};
    //! [best]
    ConflictBased best{corridor};
    if (best.find(errands) == Outcome::found)
        std::cout << "Together " << best.tiles() << " steps, after " << best.tree() << " nodes of the tree\n";
    //! [best]
    const std::vector<std::vector<Cell>> plans{best.plan(0), best.plan(1)};
    claim("nobody meets anybody", !first_meeting(plans));
    claim("eight steps each, two into the bay and out, and one that is waited", best.tiles() == 19);

    std::cout << "20 crowds each; the best plan is given up after 2000 nodes of the tree\n";
    workbook::Columns table({"agents", "solved", "nodes of the tree", "by ranks as well", "dearer by"});
    const auto tenths = [](double x) { return workbook::printed(std::fixed, std::setprecision(1), x); };
    std::vector<double> agents, nodes, searches;
    double gap = 0;
    std::size_t first_solved = 0, last_solved = 0;
    bool never_cheaper = true;
    for (const std::size_t n : {2, 4, 6, 8, 10, 12}) {
        std::mt19937 random(11);
        std::size_t solved = 0, ranked = 0, tree = 0, expanded = 0;
        double dearer = 0;
        for (int i = 0; i < 20; ++i) {
            Grid<> square(8, 8);
            const auto all = crowd(square, random, n);
            ConflictBased together{square};
            const bool found = together.find(all, 2000) == Outcome::found;
            solved += std::size_t(found), tree += together.tree(), expanded += together.expanded();
            Prioritised one_by_one{square};
            if (!one_by_one.find(all) || !found) continue;
            double tiles = 0;
            for (std::size_t k = 0; k < n; ++k) {
                const auto& plan = one_by_one.plan(k);
                for (std::size_t s = 1; s < plan.size(); ++s)
                    tiles += plan[s].x != plan[s - 1].x && plan[s].y != plan[s - 1].y ? std::sqrt(2.0) : 1.0;
            }
            ++ranked;
            dearer += tiles / together.tiles() - 1;
            never_cheaper = never_cheaper && tiles > together.tiles() * (1 - 1e-9);
        }
        if (n == 2) first_solved = solved;
        last_solved = solved;
        if (ranked > 0) gap = std::max(gap, dearer / double(ranked));
        table.row(n, solved, tenths(double(tree) / 20), ranked,
                  workbook::printed(tenths(ranked > 0 ? 100 * dearer / double(ranked) : 0.0), " %"));
        agents.push_back(double(n)), nodes.push_back(double(tree) / 20), searches.push_back(double(expanded) / 20);
    }
    std::cout << table;
    claim("what ranks find is never cheaper than the best", never_cheaper);
    claim("the tree grows faster than the number of agents, to more than 20 times with 6 times as many",
          nodes.back() > 20 * nodes.front());
    claim("with two agents all are solved, with twelve not all", first_solved == 20 && last_solved < 20);
    workbook::Plot{"6.3.11", "The best plan for all costs more and more to find"}
        .x("agents")
        .y("nodes expanded")
        .log_y()
        .linked_points("of the tree", agents, nodes)
        .linked_points("in space and time", agents, searches)
        .write();

    // A hundred steps of a crowd that plans 16 ahead.
    //! [window]
    Grid<> square(8, 8);
    std::mt19937 random(5);
    Windowed team{square, 16};
    team.begin(crowd(square, random, 16));
    while (!team.all_arrived() && team.stalled() < 50) team.step();
    //! [window]
    workbook::say() << "A crowd of 16 on 64 tiles, 16 steps ahead: all there after " << team.steps() << " steps, "
                    << team.expanded() / 16 << " nodes an agent\n";
    claim("all have arrived", team.all_arrived());

    std::mt19937 again(5);
    Grid<> same(8, 8);
    const auto sixteen = crowd(same, again, 16);
    draw(same, sixteen);

    Windowed two{corridor, 16};
    two.begin(errands);
    while (!two.all_arrived() && two.stalled() < 50) two.step();
    claim("in the corridor it stalls, as ranks do", !two.all_arrived());

    return claim.result();
}
