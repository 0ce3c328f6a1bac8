// expect: Manhattan, Octile and Chebyshev count the tiles of a grid
// SPDX-License-Identifier: BSL-1.0
// A heuristic of grids on way points.

#include <ansatz/paths.hpp>

using namespace ansatz;
using namespace ansatz::paths;

int main() {
    Grid<> map(4, 4);
#ifdef ANSATZ_MISTAKE
    const Waypoints<> ways;
    AStar search{ways, Octile{}};
#else
    const Waypoints<> ways;
    AStar search{ways, Euclid{}};
#endif
}
