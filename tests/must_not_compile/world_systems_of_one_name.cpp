// expect: two systems of one name stand at one phase of the step
// SPDX-License-Identifier: BSL-1.0
// Which of two systems comes first is said by their names, never by the list.

#include <ansatz/world.hpp>

using namespace ansatz;

template <int Which> struct Stir {
    using role = roles::System;
    template <class S> struct Turn {
        static constexpr Phase phase = phases::end;
        static constexpr std::string_view name =
#ifdef ANSATZ_MISTAKE
            "stir"
#else
            Which == 1 ? "stir" : "stir again"
#endif
            ;
        using writes = Columns<Velocity>;
        explicit Turn(const Stir&) {}
        void apply(auto& v, const auto&) const { v *= typename S::Scalar(0.5); }
    };
    template <class S> using systems = Types<Turn<S>>;
};

int main() {
    World world{SemiImplicitEuler{}, Stir<1>{}, Stir<2>{}};
    world.step(0.1 * second);
}
