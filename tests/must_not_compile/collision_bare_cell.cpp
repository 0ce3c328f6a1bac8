// expect: a bare number where a quantity belongs; multiply it with its unit
// SPDX-License-Identifier: BSL-1.0
// The width of a cell has a unit.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    const UniformGrid<> grid{0.5};
#else
    const UniformGrid<> grid{0.5 * metre};
#endif
    return grid.cell.value() > 0 ? 0 : 1;
}
