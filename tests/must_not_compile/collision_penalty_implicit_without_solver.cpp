// expect: its solver is not included; add #include
// SPDX-License-Identifier: BSL-1.0
// Contacts under implicit Euler are one system of equations, and nobody brought the solver for it.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{ImplicitEulerBy<Cholesky>{}, BoundingBoxes{}, Narrowphase<Sphere>{},
                Penalty{}}; // cholesky.hpp is in no umbrella
#else
    World world{SemiImplicitEuler{}, BoundingBoxes{}, Narrowphase<Sphere>{}, Penalty{}};
#endif
    world.step(0.01 * second);
}
