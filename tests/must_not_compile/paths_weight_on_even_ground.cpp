// expect: the ground of this grid is even; for weights take Grid<Eight<>, Terrain>
// SPDX-License-Identifier: BSL-1.0
// A weight on a grid that keeps none.

#include <ansatz/paths.hpp>

using namespace ansatz;
using namespace ansatz::paths;

int main() {
    Grid<> map(4, 4);
#ifdef ANSATZ_MISTAKE
    map.set_weight(Cell{1, 1}, 2);
#else
    Grid<Eight<>, Terrain>(4, 4).set_weight(Cell{1, 1}, 2);
#endif
}
