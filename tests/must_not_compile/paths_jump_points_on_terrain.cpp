// expect: JumpPoints need a grid of eight directions on even ground, Grid<Eight<...>, Even>; elsewhere leave them out
// SPDX-License-Identifier: BSL-1.0
// Jump points where tiles have weights.

#include <ansatz/paths.hpp>

using namespace ansatz;
using namespace ansatz::paths;

int main() {
#ifdef ANSATZ_MISTAKE
    Grid<Eight<>, Terrain> map(4, 4);
#else
    Grid<> map(4, 4);
#endif
    AStar search{map, JumpPoints{}};
    search.find(Cell{0, 0}, Cell{3, 3});
}
