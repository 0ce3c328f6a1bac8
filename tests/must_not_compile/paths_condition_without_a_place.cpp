// expect: a goal that is a condition is at no place that this heuristic could estimate the way to
// SPDX-License-Identifier: BSL-1.0
// A distance to a goal of which nobody knows where it is.

#include <ansatz/paths/a_star.hpp>
#include <ansatz/paths/grid/graph.hpp>

using namespace ansatz::paths;

int main() {
    const Grid<> map(4, 4);
    const auto border = [](Cell c) { return c.x == 3; };
    AStar fine{map, GoalWhere{border}};
    fine.find(Cell{0, 0});
#ifdef ANSATZ_MISTAKE
    AStar search{map, GoalWhere{border}, Octile{}};
    search.find(Cell{0, 0});
#endif
}
