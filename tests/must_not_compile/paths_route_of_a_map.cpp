// expect: a Route is of a search, which it uses again and again
// SPDX-License-Identifier: BSL-1.0
// A route of the map and not of a search on it.

#include <ansatz/paths.hpp>

using namespace ansatz::paths;

int main() {
    Grid<> map(4, 4);
#ifdef ANSATZ_MISTAKE
    Route route{map};
#else
    AStar search{map};
    Route route{search};
#endif
    route.go(Cell{0, 0}, Cell{3, 3});
}
