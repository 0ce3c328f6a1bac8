// expect: Swept of something that is no narrowphase; write e.g. Swept<Narrowphase<Sphere, Plane, Box>>{}
// SPDX-License-Identifier: BSL-1.0
// Swept is given a shape.

#include <ansatz/collision.hpp>
#include <ansatz/motion.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    Swept<Sphere> narrowphase;
#else
    Swept<Narrowphase<Sphere>> narrowphase;
#endif
    static_assert(sizeof(narrowphase) > 0);
}
