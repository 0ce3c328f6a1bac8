// expect: float and double are mixed in one expression
// SPDX-License-Identifier: BSL-1.0
// A parameter that was not converted to the scalar of the space.

#include <ansatz/world.hpp>

using namespace ansatz;

#ifdef ANSATZ_MISTAKE
struct Wind {
    using role = roles::Force;
    using reads = Columns<Velocity>;
    template <class S> struct In {
        explicit In(const Wind&) {}
        Quantity<unit::Frequency> rate = 2.0 / second;
        typename S::Acceleration acceleration(const typename S::Velocity& v, const auto&) const { return -(rate * v); }
    };
};
#else
struct Wind {
    using role = roles::Force;
    using reads = Columns<Velocity>;
    template <class S> struct In {
        explicit In(const Wind&) {}
        typename S::template ScalarOf<unit::Frequency> rate = S::convert(2.0 / second);
        typename S::Acceleration acceleration(const typename S::Velocity& v, const auto&) const { return -(rate * v); }
    };
};
#endif

int main() {
    World world{Space<float, 3>{}, SemiImplicitEuler{}, Wind{}};
    world.add(position(metres(0, 10, 0)));
    world.step(0.1 * second);
}
