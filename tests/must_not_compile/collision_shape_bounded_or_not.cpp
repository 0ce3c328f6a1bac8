// expect: a shape that does not say what it is
// SPDX-License-Identifier: BSL-1.0
// Whether a box holds it, nobody can guess.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

struct Capsule {
    using shape = Capsule;
    static constexpr std::string_view name = "Capsule";
#ifndef ANSATZ_MISTAKE
    static constexpr bool bounded = true;
#endif
    Parameter<unit::Length> radius, length;
    template <class S> struct In {
        using description = Capsule;
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
