// expect: World has a broadphase but no narrowphase to test its pairs; add one
// SPDX-License-Identifier: BSL-1.0
// Pairs that no narrowphase tests.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{SemiImplicitEuler{}, BoundingBoxes{}, Impulse<>{}};
#else
    World world{SemiImplicitEuler{}, BoundingBoxes{}, Layers{}, Narrowphase<Sphere>{}, Impulse<>{}};
#endif
    world.step(0.01 * second);
}
