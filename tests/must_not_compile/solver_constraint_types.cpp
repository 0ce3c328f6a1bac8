// expect: a policy that gives constraints and does not say of which types; its In<S> needs e.g. `using constraint_types = Types<MyConstraint<S>>;`
// SPDX-License-Identifier: BSL-1.0
// Constraints whose types nobody names.

#include <ansatz/soft_bodies/xpbd.hpp>
#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

struct Ties {
    using role = roles::Force;
    using reads = Columns<Position>;
    static constexpr bool couples_bodies = true;
    template <class S> struct In {
#ifndef ANSATZ_MISTAKE
        using constraint_types = Types<SpringConstraint<S, springs::Acts::both_ways>>;
#endif
        explicit In(const Ties&) {}
        void couple(auto&, const auto&) const {}
        void constraints(const auto& view, auto&& f) const {
            if (view.size() > 1) f(SpringConstraint<S, springs::Acts::both_ways>{{0, 1}, 1, 100, 0});
        }
    };
};

int main() {
    World world{SemiImplicitEuler{}, Ties{}, Xpbd{}};
    world.step(0.1 * second);
}
