// expect: a force without columns; declare what it reads
// SPDX-License-Identifier: BSL-1.0
// A force that does not say what it reads.

#include <ansatz/world.hpp>

using namespace ansatz;

#ifdef ANSATZ_MISTAKE
struct Wind {
    using role = roles::Force;
    template <class S> struct In {
        explicit In(const Wind&) {}
        typename S::Acceleration acceleration(const typename S::Velocity& v, const auto& context) const {
            return v / (16.0 * context.dt());
        }
    };
};
#else
struct Wind {
    using role = roles::Force;
    using reads = Columns<Velocity>;
    template <class S> struct In {
        explicit In(const Wind&) {}
        typename S::Acceleration acceleration(const typename S::Velocity& v, const auto& context) const {
            return v / (16.0 * context.dt());
        }
    };
};
#endif

int main() {
    World world{SemiImplicitEuler{}, Wind{}};
    world.add(position(metres(0, 10, 0)));
    world.step(0.1 * second);
}
