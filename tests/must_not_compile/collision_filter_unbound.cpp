// expect: a collision filter that cannot be bound to a space; it needs `template <class S> struct In`
// SPDX-License-Identifier: BSL-1.0
// A filter whose In is not made from it.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

struct Teams {
    using role = roles::Filter;
    using reads = Columns<Member>;
    template <class S> struct In {
#ifndef ANSATZ_MISTAKE
        explicit In(const Teams&) {}
#endif
        bool passes(const auto&, const auto&) const { return true; }
    };
};

int main() {
    World world{SemiImplicitEuler{}, Gravity{}, BoundingBoxes{}, Teams{}, Narrowphase<Sphere, Plane>{}, Impulse<>{}};
    world.step(0.01 * second);
}
