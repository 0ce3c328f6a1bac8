// expect: FixedStep takes the time of a step
// SPDX-License-Identifier: BSL-1.0
// Seconds without their unit.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    FixedStep clock{1.0 / 60};
#else
    FixedStep clock{1.0 / 60 * second};
#endif
}
