// expect: two shapes of a Narrowphase that nothing knows how to collide
// SPDX-License-Identifier: BSL-1.0
// The same question without a world.

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

int main() {
#ifdef ANSATZ_MISTAKE
    contact(Capsule{0.5 * metre, 1.0 * metre}, metres(0, 0, 0), Sphere{0.5 * metre}, metres(0, 1, 0));
#else
    contact(Sphere{0.5 * metre}, metres(0, 0, 0), Sphere{0.5 * metre}, metres(0, 1, 0));
#endif
}
