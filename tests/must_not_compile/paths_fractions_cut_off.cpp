// expect: the weights of this graph have fractions, which a whole-number cost would cut off
// SPDX-License-Identifier: BSL-1.0
// Whole numbers for a graph whose roads are measured in metres.

#include <ansatz/paths.hpp>

using namespace ansatz;
using namespace ansatz::paths;

int main() {
    const Waypoints<> ways;
#ifdef ANSATZ_MISTAKE
    AStar search{ways, CostIn<int>{}};
#else
    AStar search{ways, CostIn<float>{}};
#endif
}
