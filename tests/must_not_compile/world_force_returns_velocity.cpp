// expect: a force that answers with another quantity
// SPDX-License-Identifier: BSL-1.0
// A law that returns a velocity where an acceleration belongs.

#include <ansatz/world.hpp>

using namespace ansatz;

#ifdef ANSATZ_MISTAKE
struct Wind {
    using role = roles::Force;
    using reads = Columns<Velocity>;
    template <class S> struct In {
        explicit In(const Wind&) {}
        auto acceleration(const typename S::Velocity& v, const auto&) const { return v; }
    };
};
#else
struct Wind {
    using role = roles::Force;
    using reads = Columns<Velocity>;
    template <class S> struct In {
        explicit In(const Wind&) {}
        auto acceleration(const typename S::Velocity& v, const auto& context) const {
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
