// expect: a shape that cannot be copied; it and its In<S> are stored by kind
// SPDX-License-Identifier: BSL-1.0
// A shape that is only moved.

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
#ifdef ANSATZ_MISTAKE
        typename S::Length reach;
        In(In&&) = default;
#else
        typename S::Length reach;
#endif
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
