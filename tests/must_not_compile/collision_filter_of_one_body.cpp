// expect: a collision filter with a wrong signature; its In<S> needs `bool passes(const auto& a, const auto& b) const`
// SPDX-License-Identifier: BSL-1.0
// A filter is asked about two bodies.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

struct Teams {
    using role = roles::Filter;
    using reads = Columns<Member>;
    template <class S> struct In {
        explicit In(const Teams&) {}
#ifdef ANSATZ_MISTAKE
        bool passes(const auto&) const { return true; }
#else
        bool passes(const auto&, const auto&) const { return true; }
#endif
    };
};

int main() {
    World world{SemiImplicitEuler{}, Gravity{}, BoundingBoxes{}, Teams{}, Narrowphase<Sphere, Plane>{}, Impulse<>{}};
    world.step(0.01 * second);
}
