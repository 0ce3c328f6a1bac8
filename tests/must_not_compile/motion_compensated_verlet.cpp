// expect: Compensated of something that does not advance a position and a velocity by stages; write e.g. Compensated<SemiImplicitEuler>, and in the place of Verlet Compensated<VelocityVerlet>
// SPDX-License-Identifier: BSL-1.0
// A history of rounded positions has no velocity that could be kept.

#include <ansatz/motion.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{Compensated<Verlet>{}, Gravity{}};
#else
    World world{Compensated<VelocityVerlet>{}, Gravity{}};
#endif
    world.step(0.01 * second);
}
