// expect: GateSearch cuts a map of tiles into squares; it needs a Grid
// SPDX-License-Identifier: BSL-1.0
// Squares of a graph that has no tiles.

#include <ansatz/paths.hpp>

using namespace ansatz;
using namespace ansatz::paths;

int main() {
#ifdef ANSATZ_MISTAKE
    const Waypoints<> map;
#else
    const Grid<> map(64, 64);
#endif
    GateSearch search{map};
    search.find({0, 0}, {3, 3});
}
