// expect: two drivers of a step overlap; one must own the phases of the other
// SPDX-License-Identifier: BSL-1.0
// A driver owns a range of phases, and those of another lie within it or outside.

#include <ansatz/world.hpp>

using namespace ansatz;

template <int Which> struct Halves {
    using role = roles::System;
    template <class S> struct Parts {
#ifdef ANSATZ_MISTAKE
        static constexpr Phase phase = Which == 1 ? phases::begin : phases::substeps;
        static constexpr Phase until = Which == 1 ? phases::positions : phases::fields;
#else
        static constexpr Phase phase = Which == 1 ? phases::begin : phases::substeps;
        static constexpr Phase until = Which == 1 ? phases::fields : phases::positions;
#endif
        static constexpr std::string_view name = Which == 1 ? "one" : "two";
        explicit Parts(const Halves&) {}
        void run(auto&, const auto& dt, auto& part) const {
            part(dt / 2.0);
            part.last(dt / 2.0);
        }
    };
    template <class S> struct Calm {
        static constexpr Phase phase = phases::positions;
        static constexpr std::string_view name = Which == 1 ? "calm" : "calm again";
        using writes = Columns<Velocity>;
        explicit Calm(const Halves&) {}
        void apply(auto& v, const auto&) const { v *= typename S::Scalar(0.5); }
    };
    template <class S> using systems = Types<Parts<S>, Calm<S>>;
};

int main() {
    World world{SemiImplicitEuler{}, Halves<1>{}, Halves<2>{}};
    world.step(0.1 * second);
}
