// expect: FlowField takes a queue (Heap{}, Buckets{}), CostIn<Number>{} and WeightsOf{map}
// SPDX-License-Identifier: BSL-1.0
// An estimate for what visits everything.

#include <ansatz/paths.hpp>

using namespace ansatz::paths;

int main() {
    const Grid<> map(4, 4);
#ifdef ANSATZ_MISTAKE
    FlowField field{map, Octile{}};
#else
    FlowField field{map, Buckets{}};
#endif
    field.aim(Cell{0, 0});
}
