// expect: AStar was given something that is no policy of a search
// SPDX-License-Identifier: BSL-1.0
// A number where a policy belongs.

#include <ansatz/paths.hpp>

using namespace ansatz;
using namespace ansatz::paths;

int main() {
    Grid<> map(4, 4);
#ifdef ANSATZ_MISTAKE
    AStar search{map, 1.5};
#else
    AStar search{map, Weighted{Octile{}, 1.5}, NoReopening{}};
#endif
}
