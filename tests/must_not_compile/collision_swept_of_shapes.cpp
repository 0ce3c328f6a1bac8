// expect: Swept of something that is no narrowphase; write e.g. Swept<Narrowphase<Sphere, Plane, Box>>{}
// SPDX-License-Identifier: BSL-1.0
// Shapes where the narrowphase of these shapes belongs.

#include <ansatz/collision.hpp>
#include <ansatz/motion.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{SemiImplicitEuler{}, SortAndSweep{}, Swept<Sphere, Box>{}, Impulse{}};
#else
    World world{SemiImplicitEuler{}, SortAndSweep{}, Swept<Narrowphase<Sphere, Box>>{}, Impulse{}};
#endif
    (void)world;
}
