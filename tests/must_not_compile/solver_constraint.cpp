// expect: what `constraints` gives is no constraint; it needs `bodies`, `slots`, `stiffness`, `damping`, `one_sided` and `Scalar linearise(x, gradient) const`
// SPDX-License-Identifier: BSL-1.0
// A constraint that does not say how stiff it is.

#include <ansatz/soft_bodies/xpbd.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

template <class S> struct KeepHeight {
    static constexpr std::size_t bodies = 1;
    static constexpr bool one_sided = false;
    std::array<std::size_t, 1> slots;
#ifndef ANSATZ_MISTAKE
    typename S::Scalar stiffness = 100;
#endif
    typename S::Scalar damping = 0;
    using Vec = Vector<typename S::Scalar, S::dimension>;
    typename S::Scalar linearise(const std::array<Vec, 1>& x, std::array<Vec, 1>& gradient) const {
        gradient[0] = Vec::Unit(1);
        return x[0][1];
    }
};
struct Heights {
    using role = roles::Force;
    using reads = Columns<Position>;
    static constexpr bool couples_bodies = true;
    template <class S> struct In {
        using constraint_types = Types<KeepHeight<S>>;
        explicit In(const Heights&) {}
        void couple(auto&, const auto&) const {}
        void constraints(const auto& view, auto&& f) const {
            if (view.size() > 0) f(KeepHeight<S>{{0}});
        }
    };
};

int main() {
    World world{SemiImplicitEuler{}, Heights{}, Xpbd{}};
    world.step(0.1 * second);
}
