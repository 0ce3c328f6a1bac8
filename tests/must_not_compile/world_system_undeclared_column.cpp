// expect: a system touches a column that it did not declare; add it to its `reads`
// SPDX-License-Identifier: BSL-1.0
// A system of a policy touches the columns that it declares.

#include <ansatz/world.hpp>

using namespace ansatz;

struct Stir {
    using role = roles::System;
    template <class S> struct Turn {
        static constexpr Phase phase = phases::end;
        static constexpr std::string_view name = "stir";
#ifdef ANSATZ_MISTAKE
        using reads = Columns<Velocity>;
#else
        using writes = Columns<Velocity>;
#endif
        explicit Turn(const Stir&) {}
        void run(auto& view, const auto&) const {
            for (std::size_t slot = 0; slot < view.end(Motion::awake); ++slot)
                view.template set<Velocity>(slot, view.template get<Velocity>(slot));
        }
    };
    template <class S> using systems = Types<Turn<S>>;
};

int main() {
    World world{SemiImplicitEuler{}, Stir{}};
    world.step(0.1 * second);
}
