// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Unjoined`: bodies that a spring joins are not tested, so that cloth meets itself but not its own threads (notes
/// 4).
///
/// Use it for cloth and ropes whose particles are thicker than half of what lies between them: without it neighbours
/// push each other apart in every step, against the springs that hold them. It reads the networks that it names,
/// `Unjoined<Springs<>>{}`, so that a spring that breaks or is added is known at once. To ask about a pair is to go
/// through the springs of one of its bodies. Of hinges and enclosures it knows nothing: their bodies are joined by
/// threads, too.
///
/// Asked from outside (`world.query()`), every body is tested.

#include <ansatz/collision/roles.hpp>
#include <ansatz/springs/springs.hpp>

#include <cstddef>
#include <string_view>

namespace ansatz {

/// Two bodies are tested unless a spring joins them.
/// \tparam Networks policies that keep springs: Springs, Ropes, or both
template <class... Networks> struct Unjoined {
    static_assert(sizeof...(Networks) > 0,
                  "Ansatz: Unjoined names the springs that it reads; write e.g. Unjoined<Springs<>>{}");
    using role = roles::Filter;
    using reads = Columns<>;
    using sees = Types<Networks...>;                     ///< the networks
    static constexpr std::string_view name = "Unjoined"; ///< in a saved file
    static void parameters(auto&, auto&&) {}

    /// Bound to a space.
    template <class S> struct In {
        explicit In(const Unjoined&) {}
        /// Whether the bodies in two slots are tested.
        bool passes(const auto& view, std::size_t a, std::size_t b) const {
            return !(view.template table<Networks>().joins(view.id(a), view.id(b)) || ...);
        }
    };
};

} // namespace ansatz
