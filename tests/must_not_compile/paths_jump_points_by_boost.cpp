// expect: BoostAStar visits every edge; with JumpPoints take OwnLoop, the default engine
// SPDX-License-Identifier: BSL-1.0
// Jump points asked of boost::astar_search.

#include <ansatz/paths.hpp>

using namespace ansatz;
using namespace ansatz::paths;

int main() {
    Grid<> map(4, 4);
#ifdef ANSATZ_MISTAKE
    AStar search{map, JumpPoints{}, BoostAStar{}};
#else
    AStar search{map, JumpPoints{}};
#endif
    search.find(Cell{0, 0}, Cell{3, 3});
}
