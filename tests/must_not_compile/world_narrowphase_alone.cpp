// expect: World has a narrowphase but no broadphase to find its pairs; add one
// SPDX-License-Identifier: BSL-1.0
// A narrowphase to which nobody brings pairs.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{SemiImplicitEuler{}, Narrowphase<Sphere>{}, Impulse<>{}};
#else
    World world{SemiImplicitEuler{}, BoundingBoxes{}, Layers{}, Narrowphase<Sphere>{}, Impulse<>{}};
#endif
    world.step(0.01 * second);
}
