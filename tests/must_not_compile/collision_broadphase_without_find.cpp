// expect: a broadphase with a wrong signature; its In<S> needs `template <class F> void find(const Boxes<S>& boxes, F&& found)`
// SPDX-License-Identifier: BSL-1.0
// A broadphase that does not take a function for the pairs.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

struct EveryPair {
    using role = roles::Broadphase;
    template <class S> struct In {
        explicit In(const EveryPair&) {}
#ifdef ANSATZ_MISTAKE
        void find(const Boxes<S>&) {}
#else
        template <class F> void find(const Boxes<S>&, F&&) {}
#endif
    };
};

int main() {
    World world{SemiImplicitEuler{}, Gravity{}, EveryPair{}, Narrowphase<Sphere, Plane>{}, Impulse<>{}};
    world.step(0.01 * second);
}
