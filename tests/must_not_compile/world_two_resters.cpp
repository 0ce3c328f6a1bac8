// expect: World has more than one policy that puts bodies to rest; keep one
// SPDX-License-Identifier: BSL-1.0
// Two policies that put bodies to rest.

#include <ansatz/world.hpp>

using namespace ansatz;

struct Nap : Rest {
    template <class S> struct In : Rest::In<S> {
        explicit In(const Nap& nap) : Rest::In<S>(nap) {}
    };
};

int main() {
#ifdef ANSATZ_MISTAKE
    World world{SemiImplicitEuler{}, Rest{}, Nap{}};
#else
    World world{SemiImplicitEuler{}, Rest{}};
#endif
    world.step(0.1 * second);
}
