// expect: LazyTheta walks straight over the tiles of a grid on even ground
// SPDX-License-Identifier: BSL-1.0
// Straight lines over ground that weighs.

#include <ansatz/paths.hpp>

using namespace ansatz::paths;

int main() {
#ifdef ANSATZ_MISTAKE
    const Grid<Eight<>, Terrain> map(4, 4);
#else
    const Grid<> map(4, 4);
#endif
    AStar search{map, LazyTheta{}};
    search.find(Cell{0, 0}, Cell{3, 3});
}
