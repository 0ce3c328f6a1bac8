// expect: LazyTheta walks straight over the tiles of a grid on even ground
// SPDX-License-Identifier: BSL-1.0
// Straight lines over roads, of which there are none between.

#include <ansatz/paths.hpp>

using namespace ansatz;
using namespace ansatz::paths;

int main() {
#ifdef ANSATZ_MISTAKE
    Waypoints<> roads;
    const auto a = roads.add(metres(0, 0, 0)), b = roads.add(metres(1, 0, 0));
    AStar search{roads, LazyTheta{}};
    search.find(a, b);
#else
    const Grid<> map(4, 4);
    AStar search{map, LazyTheta{}};
    search.find(Cell{0, 0}, Cell{3, 3});
#endif
}
