// expect: a system changes elements of another policy where others walk over them; let its phase be one from phases::breaking on and before phases::sums
// SPDX-License-Identifier: BSL-1.0
// Tables of others are changed at one place of the step.

#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

struct Moth {
    using role = roles::System;
    template <class S> struct Eat {
#ifndef ANSATZ_MISTAKE
        static constexpr Phase phase = between(phases::breaking, phases::sums);
#else
        static constexpr Phase phase = phases::forces;
#endif
        static constexpr std::string_view name = "moth";
        using edits = Types<Spring>;
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
