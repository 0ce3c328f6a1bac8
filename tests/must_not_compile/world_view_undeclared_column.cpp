// expect: a policy touches a column that it did not declare; add it to its `reads`
// SPDX-License-Identifier: BSL-1.0
// A force between bodies that reads a column it did not declare.

#include <ansatz/world.hpp>

using namespace ansatz;

#ifdef ANSATZ_MISTAKE
struct Magnet {
    using role = roles::Force;
    using reads = Columns<Position>;
    static constexpr bool couples_bodies = true;
    template <class S> struct In {
        explicit In(const Magnet&) {}
        void couple(auto& view, const auto& context) const {
            for (std::size_t i = 0; i < view.size(); ++i)
                view.add_force(i, -(S::convert(2.0 * kilogram) * view.template get<Velocity>(i) / context.dt()));
        }
    };
};
#else
struct Magnet {
    using role = roles::Force;
    using reads = Columns<Velocity>;
    static constexpr bool couples_bodies = true;
    template <class S> struct In {
        explicit In(const Magnet&) {}
        void couple(auto& view, const auto& context) const {
            for (std::size_t i = 0; i < view.size(); ++i)
                view.add_force(i, -(S::convert(2.0 * kilogram) * view.template get<Velocity>(i) / context.dt()));
        }
    };
};
#endif

int main() {
    World world{SemiImplicitEuler{}, Magnet{}};
    world.add(mass(2.0 * kilogram));
    world.step(0.1 * second);
}
