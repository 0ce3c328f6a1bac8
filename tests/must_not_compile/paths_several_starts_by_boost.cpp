// expect: this engine searches from one start
// SPDX-License-Identifier: BSL-1.0
// Several starts for an engine that knows one.

#include <ansatz/paths/a_star.hpp>
#include <ansatz/paths/boost_a_star.hpp>
#include <ansatz/paths/grid/graph.hpp>

#include <vector>

using namespace ansatz::paths;

int main() {
    const Grid<> map(4, 4);
    const std::vector<Cell> starts{{0, 0}, {3, 0}};
    AStar search{map, BoostAStar{}};
    search.find(starts.front(), Cell{2, 2});
#ifdef ANSATZ_MISTAKE
    search.find(starts, Cell{2, 2});
#endif
}
