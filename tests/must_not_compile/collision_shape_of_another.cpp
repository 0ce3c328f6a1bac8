// expect: a shape that cannot be bound to a space
// SPDX-License-Identifier: BSL-1.0
// A shape whose In says that it is made from another one.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

struct Capsule {
    using shape = Capsule;
    static constexpr std::string_view name = "Capsule";
    static constexpr bool bounded = true;
    Parameter<unit::Length> radius, length;
    template <class S> struct In {
#ifdef ANSATZ_MISTAKE
        using description = Sphere;
#else
        using description = Capsule;
#endif
        explicit In(const Capsule& capsule) : reach(S::convert(capsule.radius) + S::convert(capsule.length)) {}
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
