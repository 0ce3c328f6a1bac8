// expect: Swept of a narrowphase that is swept already; leave one Swept out
// SPDX-License-Identifier: BSL-1.0
// Swept around Swept.

#include <ansatz/collision.hpp>
#include <ansatz/motion.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    Swept<Swept<Narrowphase<Sphere>>> narrowphase;
#else
    Swept<Narrowphase<Sphere>> narrowphase;
#endif
    static_assert(sizeof(narrowphase) > 0);
}
