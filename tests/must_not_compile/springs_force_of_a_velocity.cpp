// expect: springs::force takes a stiffness and a displacement
// SPDX-License-Identifier: BSL-1.0
// Hooke's law of a velocity.

#include <ansatz/springs/hooke.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    springs::force(100.0 * newton_per_metre, 0.1 * metre_per_second);
#else
    (void)springs::force(100.0 * newton_per_metre, 0.1 * metre);
#endif
}
