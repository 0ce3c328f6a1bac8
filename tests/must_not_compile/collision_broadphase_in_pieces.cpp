// expect: a broadphase with `pieces` that cannot be searched in them; its In<S> needs `void prepare(const Boxes<S>& boxes
// SPDX-License-Identifier: BSL-1.0
// A broadphase that is to be searched by several threads, by a function that may change it.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

struct EveryPair {
    using role = roles::Broadphase;
    template <class S> struct In {
        explicit In(const EveryPair&) {}
        template <class F> void find(const Boxes<S>&, F&&) {}
        void prepare(const Boxes<S>&, const auto&) {}
        std::size_t pieces() const { return 0; }
#ifdef ANSATZ_MISTAKE
        template <class F> void find(const Boxes<S>&, std::size_t, std::size_t, F&&) {}
#else
        template <class F> void find(const Boxes<S>&, std::size_t, std::size_t, F&&) const {}
#endif
    };
};

int main() {
    World world{SemiImplicitEuler{}, Gravity{}, EveryPair{}, Narrowphase<Sphere, Plane>{}, Impulse<>{}};
    world.step(0.01 * second);
}
