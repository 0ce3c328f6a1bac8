// expect: springs::between takes behind its two vectors a rest length, a stiffness and a damping
// SPDX-License-Identifier: BSL-1.0
// A stiffness without its unit.

#include <ansatz/springs/hooke.hpp>

using namespace ansatz;

int main() {
    const auto none = 0.0 * newton_second_per_metre;
#ifdef ANSATZ_MISTAKE
    (void)springs::between(metres(0, 1, 0), metres_per_second(0, 0, 0), 1.0 * metre, 100.0, none);
#else
    (void)springs::between(metres(0, 1, 0), metres_per_second(0, 0, 0), 1.0 * metre, 100.0 * newton_per_metre, none);
#endif
}
