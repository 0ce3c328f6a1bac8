// expect: a broadphase that cannot be bound to a space; it needs `template <class S> class In` with a constructor
// SPDX-License-Identifier: BSL-1.0
// A broadphase whose In is not made from it.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

struct EveryPair {
    using role = roles::Broadphase;
    template <class S> struct In {
#ifndef ANSATZ_MISTAKE
        explicit In(const EveryPair&) {}
#endif
        template <class F> void find(const Boxes<S>&, F&&) {}
    };
};

int main() {
    World world{SemiImplicitEuler{}, Gravity{}, EveryPair{}, Narrowphase<Sphere, Plane>{}, Impulse<>{}};
    world.step(0.01 * second);
}
