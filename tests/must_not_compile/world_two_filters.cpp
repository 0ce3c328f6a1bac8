// expect: World has more than one collision filter; keep one
// SPDX-License-Identifier: BSL-1.0
// Two policies in a role for one.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

struct Teams {
    using role = roles::Filter;
};

int main() {
#ifdef ANSATZ_MISTAKE
    World world{SemiImplicitEuler{}, BoundingBoxes{}, Layers{}, Teams{}, Narrowphase<Sphere>{}, Impulse<>{}};
#else
    World world{SemiImplicitEuler{}, BoundingBoxes{}, Layers{}, Narrowphase<Sphere>{}, Impulse<>{}};
#endif
    world.step(0.01 * second);
}
