// expect: AStar is told twice what its goal is
// SPDX-License-Identifier: BSL-1.0
// A set and a condition at once.

#include <ansatz/paths/a_star.hpp>
#include <ansatz/paths/grid/graph.hpp>

using namespace ansatz::paths;

int main() {
    const Grid<> map(4, 4);
    const auto border = [](Cell c) { return c.x == 3; };
    AStar fine{map, GoalWhere{border}};
    fine.find(Cell{0, 0});
#ifdef ANSATZ_MISTAKE
    AStar search{map, GoalWhere{border}, AnyGoal{}};
#endif
}
