// SPDX-License-Identifier: BSL-1.0
// 6.3.10 One after the other: plans for many in space and time, and what the order does

// All at once is too much (6.3.4). The usual way out gives everybody a rank: the first plans for itself, and reserves
// its tiles, each for the step in which it is there; the second plans around that, and so on. A search then runs for a
// tile and a step, and waiting is something that one can do. It takes as long as so many single searches. What it
// cannot do is have the first make way for the second: there are crowds that it has no plan for, though there is one,
// and others for which it depends on the order. (A part of section 6.3, beyond the notes.)

#include "claims.hpp"
#include "drawing.hpp"
#include "say.hpp"

#include <ansatz/paths.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <iomanip>
#include <iostream>
#include <random>
#include <string>
#include <vector>

using namespace ansatz;
using namespace ansatz::paths;

namespace {

/// Whether two are in one tile, or change places, in any step.
bool meet(const std::vector<std::vector<Cell>>& plans, std::size_t steps) {
    const auto at = [&](std::size_t i, std::size_t s) { return plans[i][std::min(s, plans[i].size() - 1)]; };
    for (std::size_t s = 0; s <= steps; ++s)
        for (std::size_t i = 0; i < plans.size(); ++i)
            for (std::size_t k = 0; k < i; ++k)
                if (at(i, s) == at(k, s) || (at(i, s) == at(k, s + 1) && at(i, s + 1) == at(k, s))) return true;
    return false;
}

/// The ways of some, as their plans are.
void draw(const Grid<>& map, const Prioritised<Grid<>>& plans, std::size_t agents) {
    workbook::Plot plot("6.3.10", "Five cross a square, each planned around those before it");
    drawing::with_walls(plot, map);
    drawing::Places goals;
    for (std::size_t i = 0; i < agents; ++i) {
        drawing::way(plot, map, "agent " + std::to_string(i + 1), plans.plan(i));
        goals.add(map, plans.plan(i).back());
    }
    plot.points("goals", goals.east, goals.north).write();
}

} // namespace

int main() {
    workbook::Claims claim;

    // A corridor with a bay near its right end: A comes from the left, B from the right.
    const auto corridor = grid_from<Grid<Four>>({"######.##", ".........", "#########"});
    //! [plan]
    Prioritised search{corridor};
    const std::array<Errand, 2> a_first{Errand{{0, 1}, {8, 1}}, Errand{{8, 1}, {0, 1}}};
    const bool planned = search.find(a_first);
    for (std::size_t step = 0; planned && step <= search.steps(); ++step) // who is where
        std::cout << "  " << std::setw(2) << step << ": A " << name_of(search.at(0, step)) << "  B "
                  << name_of(search.at(1, step)) << '\n';
    //! [plan]
    claim("if A is first, B steps into the bay and lets it pass", planned);
    claim("nobody meets anybody", !meet({search.plan(0), search.plan(1)}, search.steps()));

    //! [order]
    const std::array<Errand, 2> b_first{a_first[1], a_first[0]};
    if (!search.find(b_first)) workbook::say() << search.why() << '\n';
    //! [order]
    claim("if B is first there is no plan: A is not at the bay in time", search.failed() == 1);

    const auto middle = grid_from<Grid<Four>>({"####.####", ".........", "#########"});
    Prioritised both{middle};
    claim("with the bay in the middle no order has a plan, though there is one (6.3.4)",
          !both.find(a_first) && !both.find(b_first));

    // Crowds: a square of 16 x 16 tiles, every tenth blocked, and more and more who cross it.
    std::cout << "Of 40 crowds, how many have a plan in the first order, and in any of ten\n";
    std::size_t before = 40;
    bool fewer = true, any_helps = false;
    for (const std::size_t n : {5, 10, 20, 40}) {
        std::mt19937 random(3);
        std::size_t first = 0, any = 0, expanded = 0;
        for (int crowd = 0; crowd < 40; ++crowd) {
            Grid<> square(16, 16);
            for (int i = 0; i < 25; ++i)
                square.set_passable(Cell{std::uint16_t(random() % 16), std::uint16_t(random() % 16)}, false);
            std::vector<Errand> errands;
            while (errands.size() < n) {
                const Errand one{{std::uint16_t(random() % 16), std::uint16_t(random() % 16)},
                                 {std::uint16_t(random() % 16), std::uint16_t(random() % 16)}};
                const bool taken = std::any_of(errands.begin(), errands.end(), [&](const Errand& other) {
                    return other.start == one.start || other.goal == one.goal;
                });
                AStar alone{square};
                if (!taken && alone.find(one.start, one.goal) == Outcome::found) errands.push_back(one);
            }
            Prioritised plans{square};
            bool found = plans.find(errands);
            first += std::size_t(found);
            if (n == 5 && crowd == 0 && found) draw(square, plans, n);
            if (found) expanded += plans.expanded();
            for (int order = 1; order < 10 && !found; ++order) {
                for (std::size_t i = n - 1; i > 0; --i) std::swap(errands[i], errands[random() % (i + 1)]);
                found = plans.find(errands);
            }
            any += std::size_t(found);
        }
        std::cout << "  " << std::setw(2) << n << " agents: " << std::setw(2) << first << ", " << std::setw(2) << any
                  << "; nodes an agent " << (first > 0 ? expanded / first / n : 0) << '\n';
        fewer = fewer && first <= before;
        any_helps = any_helps || any > first;
        before = first;
    }
    claim("the fuller it is, the fewer crowds have a plan", fewer);
    claim("another order helps", any_helps);

    return claim.result();
}
