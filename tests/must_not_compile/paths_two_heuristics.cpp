// expect: AStar has two heuristics; for the larger of both write Maximum{Octile{}, Euclid{}}
// SPDX-License-Identifier: BSL-1.0
// Two heuristics in one search.

#include <ansatz/paths.hpp>

using namespace ansatz;
using namespace ansatz::paths;

int main() {
    Grid<> map(4, 4);
#ifdef ANSATZ_MISTAKE
    AStar search{map, Octile{}, Euclid{}};
#else
    AStar search{map, Maximum{Octile{}, Euclid{}}};
#endif
}
