// expect: springs::critical_damping takes a stiffness and a mass
// SPDX-License-Identifier: BSL-1.0
// Mass and stiffness exchanged: their product has a root in either order.

#include <ansatz/springs/hooke.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    (void)springs::critical_damping(2.0 * kilogram, 100.0 * newton_per_metre);
#else
    (void)springs::critical_damping(100.0 * newton_per_metre, 2.0 * kilogram);
#endif
}
