// expect: an implicit integrator needs the Jacobian of every force, and this one has none
// SPDX-License-Identifier: BSL-1.0
// ImplicitEuler cannot guess a derivative.

#include <ansatz/world.hpp>

using namespace ansatz;

#ifdef ANSATZ_MISTAKE
struct Wind {
    using role = roles::Force;
    using reads = Columns<Velocity>;
    template <class S> struct In {
        explicit In(const Wind&) {}
        typename S::Acceleration acceleration(const typename S::Velocity& v, const auto&) const {
            return -(S::convert(2.0 / second) * v);
        }
    };
};
#else
struct Wind {
    using role = roles::Force;
    using reads = Columns<Velocity>;
    template <class S> struct In {
        explicit In(const Wind&) {}
        typename S::Acceleration acceleration(const typename S::Velocity& v, const auto&) const {
            return -(S::convert(2.0 / second) * v);
        }
        Jacobian<S> jacobian(const typename S::Velocity&, const auto&) const { return {}; }
    };
};
#endif

int main() {
    World world{ImplicitEuler{}, Wind{}};
    world.add(position(metres(0, 10, 0)));
    world.step(0.1 * second);
}
