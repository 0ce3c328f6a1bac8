// SPDX-License-Identifier: BSL-1.0
// A joint outside the library, against the public frame only: a rod between two bodies, one row in the solver of the
// contacts, so that rods and contacts hold each other in each substep.
#pragma once

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

namespace examples {

using namespace ansatz;

//! [rod]
struct Rod { // what world.add takes
    using element = Rod;
    Handle first, second;
    Parameter<unit::Length> length = 1.0 * metre;
};
template <class S> struct RodRow { // what is kept of it
    BodyId first, second;
    typename S::Length length{};
    typename SolverRow<S>::Impulse impulse{}; // of the last substep
    static void fields(auto& self, auto&& field) {
        field("first", self.first);
        field("second", self.second);
        field("length", self.length);
        field("impulse", self.impulse);
    }
    static RodRow from(const auto& asked, const Rod& rod) {
        return {asked.body(rod.first), asked.body(rod.second), S::convert("length", rod.length), {}};
    }
};
struct Rods {
    using role = roles::System;
    using Element = Rod;
    static constexpr std::string_view name = "Rods";
    template <class S> using State = ElementTable<S, Rod, RodRow<S>>;
    template <class S> struct Rows {
        using reads = Columns<Position>;
        explicit Rows(const Rods&) {}
        void rows(auto& view, auto&& row) const {
            view.state().for_each([&](std::uint32_t, auto& rod) {
                const auto a = view.slot(rod.first), b = view.slot(rod.second);
                const auto between = view.template get<Position>(a) - view.template get<Position>(b);
                const auto apart = norm(between);
                if (!(apart.value() > 0)) return;
                row(SolverRow<S>{a, b, between.value() / apart.value(), apart - rod.length, &rod.impulse});
            });
        }
    };
};
//! [rod]

} // namespace examples
