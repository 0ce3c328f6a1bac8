// expect: two shapes of a Narrowphase that nothing knows how to collide
// expect note: CheckPair<ansatz::Sphere, Capsule
// SPDX-License-Identifier: BSL-1.0
// A capsule meets capsules; nobody wrote what happens to it and a sphere.

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
#ifndef ANSATZ_MISTAKE
template <class S>
bool collide(const Capsule::In<S>&, const typename S::Position&, const Sphere::In<S>&, const typename S::Position&,
             Touch<S>&) {
    return false;
}
#endif

int main() {
    World world{SemiImplicitEuler{}, Gravity{}, BoundingBoxes{}, Narrowphase<Sphere, Capsule>{}, Impulse<>{}};
    world.step(0.01 * second);
}
