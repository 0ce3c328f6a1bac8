// expect: an implicit integrator needs the Jacobian of every force, and this one has none
// SPDX-License-Identifier: BSL-1.0
// Bodies that attract each other under an implicit integrator.

#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{ImplicitEuler{}, Gravity{}, Attraction{}};
#else
    World world{RungeKutta4{}, Gravity{}, Attraction{}};
#endif
    world.add(mass(2.0 * kilogram));
    world.step(0.1 * second);
}
