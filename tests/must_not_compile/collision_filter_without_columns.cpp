// expect: a collision filter without columns; declare what it reads
// SPDX-License-Identifier: BSL-1.0
// A filter that does not say what it reads of a body.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

struct Teams {
    using role = roles::Filter;
#ifndef ANSATZ_MISTAKE
    using reads = Columns<Member>;
#endif
    template <class S> struct In {
        explicit In(const Teams&) {}
        bool passes(const auto&, const auto&) const { return true; }
    };
};

int main() {
    World world{SemiImplicitEuler{}, Gravity{}, BoundingBoxes{}, Teams{}, Narrowphase<Sphere, Plane>{}, Impulse<>{}};
    world.step(0.01 * second);
}
