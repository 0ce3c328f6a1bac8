// expect: its solver is not included; add #include
// SPDX-License-Identifier: BSL-1.0
// Springs under implicit Euler are one system of equations, and nobody brought the solver for it.

#include <ansatz/springs/springs.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{ImplicitEulerBy<Cholesky>{}, Springs{}}; // cholesky.hpp is in no umbrella
#else
    World world{SemiImplicitEuler{}, Springs{}};
#endif
    const auto ball = world.add(mass(2.0 * kilogram));
    world.add(Spring{ball, metres(0, 1, 0), 100.0 * newton_per_metre});
    world.step(0.1 * second);
}
