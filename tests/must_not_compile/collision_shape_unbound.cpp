// expect: a shape that cannot be bound to a space; it needs `template <class S> struct In` with a constructor from the shape
// SPDX-License-Identifier: BSL-1.0
// A shape whose In is not made from it.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

struct Capsule {
    using shape = Capsule;
    static constexpr std::string_view name = "Capsule";
    static constexpr bool bounded = true;
    Parameter<unit::Length> radius, length;
    template <class S> struct In {
        using description = Capsule;
#ifdef ANSATZ_MISTAKE
        In() {}
#else
        explicit In(const Capsule& capsule) : reach(S::convert(capsule.radius) + S::convert(capsule.length)) {}
#endif
        void bounds(const typename S::Position& x, typename S::Position& lower, typename S::Position& upper) const {
            lower = upper = x;
        }
        typename S::Length reach;
    };
};
template <class S>
bool collide(const Capsule::In<S>&, const typename S::Position&, const Capsule::In<S>&, const typename S::Position&,
             Touch<S>&) {
    return false;
}

int main() {
    World world{SemiImplicitEuler{}, Gravity{}, BoundingBoxes{}, Narrowphase<Capsule>{}, Impulse<>{}};
    world.step(0.01 * second);
}
