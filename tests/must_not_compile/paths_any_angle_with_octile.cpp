// expect: Octile and Manhattan count steps, which is too much for an engine that walks straight between tiles
// SPDX-License-Identifier: BSL-1.0
// An estimate by steps for a search of straight lines.

#include <ansatz/paths.hpp>

using namespace ansatz::paths;

int main() {
    const Grid<> map(4, 4);
#ifdef ANSATZ_MISTAKE
    AStar search{map, Octile{}, LazyTheta{}};
#else
    AStar search{map, Euclid{}, LazyTheta{}};
#endif
    search.find(Cell{0, 0}, Cell{3, 3});
}
