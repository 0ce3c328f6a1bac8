// expect: Ansatz: decay takes a pure number; a rate becomes one by a time, e.g. decay(rate * dt)
// at most: 1 error
// SPDX-License-Identifier: BSL-1.0
// e to the power of minus 3/s: over which time?

#include <ansatz/motion/decay.hpp>
#include <ansatz/units.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    static_cast<void>(decay(3.0 / second));
#else
    static_cast<void>(decay(3.0 / second * (0.1 * second)));
#endif
}
