// expect: a narrowphase with a wrong signature; it needs all that NarrowphaseIn names
// SPDX-License-Identifier: BSL-1.0
// A wrapper that hides what it should pass on.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

struct Coarse : Narrowphase<Sphere, Plane> {
#ifdef ANSATZ_MISTAKE
    template <class S> static bool nearly_collide(const Shapes<S>&, std::uint32_t, std::uint32_t) { return false; }
#else
    using Narrowphase<Sphere, Plane>::nearly_collide;
#endif
};

int main() {
    World world{SemiImplicitEuler{}, Gravity{}, BoundingBoxes{}, Coarse{}, Impulse<>{}};
    world.step(0.01 * second);
}
