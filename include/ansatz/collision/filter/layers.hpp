// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Layers`: which bodies are tested together: each belongs to some of 24 layers, and may ignore others.
///
/// Use it for bullets that do not hit their shooter, ghosts that walls do not stop, ragdolls that do not meet
/// themselves. Two bodies are tested unless one of them ignores a layer of the other. A body that is given nothing
/// meets everything.

#include <ansatz/collision/concepts.hpp>
#include <ansatz/collision/roles.hpp>
#include <ansatz/core/error.hpp>
#include <ansatz/world/columns.hpp>
#include <ansatz/world/properties.hpp>

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>

namespace ansatz {

/// The layers that a body belongs to, as the bits of a whole number below 2^24, which every scalar holds exactly.
struct Member {
    using Unit = unit::Dimensionless;
    static constexpr Shape shape = Shape::scalar;
    static constexpr std::string_view name = "member of layers";
    static constexpr double least = 0;            ///< no layer
    static constexpr double most = (1 << 24) - 1; ///< all 24
    static constexpr bool whole = true;           ///< bits
    /// Which policy reads it.
    template <bool Stored> struct Needs {
        static_assert(Stored, "Ansatz: this world has no filter that reads layers; add Layers{} to its policies, or "
                              "leave member_of(...) and "
                              "ignores(...) out");
    };
};
/// The layers that it ignores.
struct Ignored {
    using Unit = unit::Dimensionless;
    static constexpr Shape shape = Shape::scalar;
    static constexpr std::string_view name = "ignored layers";
    static constexpr double least = Member::least; ///< none
    static constexpr double most = Member::most;   ///< all 24
    static constexpr bool whole = true;            ///< bits
    /// Which policy reads it.
    template <bool Stored> using Needs = Member::Needs<Stored>;
};

namespace detail {
template <class Column, class Bits> auto layers_given(const char* what, const Bits& layers) {
    constexpr bool bits = std::integral<Bits> && !std::same_as<Bits, bool>;
    static_assert(
        bits, "Ansatz: layers are the bits of a whole number: write e.g. member_of(1 << 3), ignores(1 << 3 | 1 << 4)");
    double number = 0;
    if constexpr (bits) {
        if (layers < Bits(0) || std::uintmax_t(layers) >= 1u << 24)
            refuse_value(what, "layers", std::to_string(layers),
                         "it is from 0 to 16777215: a bit for each of 24 layers");
        number = double(layers);
    }
    return with<Column>(Quantity<unit::Dimensionless>(number));
}
} // namespace detail

/// Says which layers a body belongs to, e.g. `member_of(1 << 3)`.
/// \throws std::invalid_argument for a number that is negative or has more than 24 bits
template <class Bits> auto member_of(const Bits& layers) { return detail::layers_given<Member>("member_of", layers); }
/// The layers that it does not meet, e.g. `ignores(1 << 3 | 1 << 4)`.
/// \throws as `member_of`
template <class Bits> auto ignores(const Bits& layers) { return detail::layers_given<Ignored>("ignores", layers); }

/// Two bodies are tested unless one of them ignores a layer of the other.
struct Layers {
    using role = roles::Filter;
    using reads = Columns<Member, Ignored>;
    static constexpr std::string_view name = "Layers";
    static void parameters(auto&, auto&&) {}

    template <class S> struct In {
        explicit In(const Layers&) {}
        /// Whether the two are tested.
        bool passes(const auto& a, const auto& b) const {
            return (bits<Ignored>(a) & bits<Member>(b)) == 0 && (bits<Ignored>(b) & bits<Member>(a)) == 0;
        }

    private:
        template <class Column> static std::uint32_t bits(const auto& row) {
            return std::uint32_t(row.template get<Column>().value());
        }
    };
};

} // namespace ansatz
