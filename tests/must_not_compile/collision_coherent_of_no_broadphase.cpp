// expect: Coherent of something that is no broadphase of boxes; write e.g. Coherent<UniformGrid<>>
// SPDX-License-Identifier: BSL-1.0
// Pairs are kept of something that finds none.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{SemiImplicitEuler{}, Coherent<int>{}, Narrowphase<Sphere>{}, Impulse<>{}};
#else
    World world{SemiImplicitEuler{}, Coherent<SortAndSweep>{}, Narrowphase<Sphere>{}, Impulse<>{}};
#endif
    world.step(0.01 * second);
}
