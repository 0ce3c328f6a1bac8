// expect: a table system with a wrong signature; it needs `void run(auto& view, const auto& context) const`
// SPDX-License-Identifier: BSL-1.0
// A table system that does not take the context.

#include <ansatz/world.hpp>

using namespace ansatz;

struct Tides {
    using role = roles::System;
    static constexpr std::string_view name = "Tides";
    template <class S> struct Rise {
        static constexpr Phase phase = phases::fields;
        static constexpr std::string_view name = "rise";
        explicit Rise(const Tides&) {}
#ifdef ANSATZ_MISTAKE
        void run(auto&) const {}
#else
        void run(auto&, const auto&) const {}
#endif
    };
    template <class S> using systems = Types<Rise<S>>;
};

int main() {
    World world{SemiImplicitEuler{}, Tides{}};
    world.step(0.01 * second);
}
