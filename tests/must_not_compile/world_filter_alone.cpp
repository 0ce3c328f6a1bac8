// expect: World has a collision filter but no broadphase whose pairs it could filter; add one
// SPDX-License-Identifier: BSL-1.0
// A filter of pairs that nobody finds.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    World world{SemiImplicitEuler{}, Layers{}};
#else
    World world{SemiImplicitEuler{}, BoundingBoxes{}, Layers{}, Narrowphase<Sphere>{}, Impulse<>{}};
#endif
    world.step(0.01 * second);
}
