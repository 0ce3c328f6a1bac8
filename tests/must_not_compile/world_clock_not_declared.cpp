// expect: a policy asks for the time that it did not declare; add Clock to its columns
// SPDX-License-Identifier: BSL-1.0
// A law that depends on time and does not say so.

#include <ansatz/world.hpp>

using namespace ansatz;

#ifdef ANSATZ_MISTAKE
struct Wind {
    using role = roles::Force;
    using reads = Columns<>;
    template <class S> struct In {
        explicit In(const Wind&) {}
        typename S::Acceleration acceleration(const auto& context) const {
            return context.time().value() > 1 ? typename S::Acceleration()
                                              : S::template zero_vector<unit::Acceleration>();
        }
    };
};
#else
struct Wind {
    using role = roles::Force;
    using reads = Columns<Clock>;
    template <class S> struct In {
        explicit In(const Wind&) {}
        typename S::Acceleration acceleration(const auto& context) const {
            return context.time().value() > 1 ? typename S::Acceleration()
                                              : S::template zero_vector<unit::Acceleration>();
        }
    };
};
#endif

int main() {
    World world{SemiImplicitEuler{}, Wind{}};
    world.add(position(metres(0, 10, 0)));
    world.step(0.1 * second);
}
