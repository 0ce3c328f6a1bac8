// expect: a policy asks for the time that it did not declare; add Clock to its columns
// SPDX-License-Identifier: BSL-1.0
// The time is not for the taking in prepare either.

#include <ansatz/world.hpp>

using namespace ansatz;

#ifdef ANSATZ_MISTAKE
struct Wind {
    using role = roles::Force;
    using reads = Columns<>;
    template <class S> struct In {
        explicit In(const Wind&) {}
        bool late = false;
        void prepare(const auto& context) { late = context.time().value() > 1; }
        typename S::Acceleration acceleration(const auto&) const { return {}; }
    };
};
#else
struct Wind {
    using role = roles::Force;
    using reads = Columns<Clock>;
    template <class S> struct In {
        explicit In(const Wind&) {}
        bool late = false;
        void prepare(const auto& context) { late = context.time().value() > 1; }
        typename S::Acceleration acceleration(const auto&) const { return {}; }
    };
};
#endif

int main() {
    World world{SemiImplicitEuler{}, Wind{}};
    world.add(position(metres(0, 10, 0)));
    world.step(0.1 * second);
}
