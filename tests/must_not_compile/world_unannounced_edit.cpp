// expect: a system changes elements without saying so; add them to its `using edits = Types<...>;`
// SPDX-License-Identifier: BSL-1.0
// What a system changes of another policy's, it declares.

#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

struct Moth {
    using role = roles::System;
    template <class S> struct Eat {
        static constexpr Phase phase = between(phases::breaking, phases::sums);
        static constexpr std::string_view name = "moth";
#ifndef ANSATZ_MISTAKE
        using edits = Types<Spring>;
#endif
        explicit Eat(const Moth&) {}
        void run(auto& view, const auto&) const {
            if (view.template edit<Spring>().size() > 3) view.template edit<Spring>().erase(0);
        }
    };
    template <class S> using systems = Types<Eat<S>>;
};

int main() {
    World world{SemiImplicitEuler{}, Springs<>{}, Moth{}};
    world.step(0.1 * second);
}
