// expect: CostIn takes a plain number
// SPDX-License-Identifier: BSL-1.0
// A quantity as the number of a search.

#include <ansatz/paths.hpp>

using namespace ansatz;
using namespace ansatz::paths;

int main() {
    Grid<> map(4, 4);
#ifdef ANSATZ_MISTAKE
    AStar search{map, CostIn<Quantity<unit::Length>>{}};
#else
    AStar search{map, CostIn<double>{}};
#endif
}
