// expect: World has a response but no narrowphase to find contacts; add one
// SPDX-License-Identifier: BSL-1.0
// A response to contacts that nobody finds.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{SemiImplicitEuler{}, Impulse<>{}};
#else
    World world{SemiImplicitEuler{}, BoundingBoxes{}, Layers{}, Narrowphase<Sphere>{}, Impulse<>{}};
#endif
    world.step(0.01 * second);
}
