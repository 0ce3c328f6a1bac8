// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `CostIn<Number>`: what g, h and f are counted in; the third choice after graph and heuristic.
///
/// - `std::uint32_t` (a grid's default): fastest, and equal costs are equal. A straight step is 33461 and a diagonal
/// one
///   47321, whose ratio is the square root of 2 to 2 parts in 10^10. Enough for 128 thousand tiles of one path; a
///   search that would need more says so (`Outcome::too_far`) and never wraps round.
/// - `std::uint64_t`: the same without that end.
/// - `double`, `float`: any weights at all. A sum of many roots of 2 drifts, so paths of equal length no longer compare
///   equal, more nodes are expanded, and float is wrong in the sixth digit.
///
/// Quantities stop here: a search calculates in plain numbers, and what it answers is given its unit again by the
/// graph.

#include <ansatz/paths/roles.hpp>

#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace ansatz::paths {

/// The number that a search calculates with: `AStar{grid, Octile{}, CostIn<double>{}}`.
template <class Number> struct CostIn {
    static_assert(
        std::is_arithmetic_v<Number> && !std::is_same_v<Number, bool>,
        "Ansatz paths: CostIn takes a plain number; write e.g. CostIn<double>, and give quantities to the graph");
    using role = roles::Cost;
    using type = Number; ///< what it calculates with
};

/// What a straight and a diagonal step over a tile of weight 1 cost in this number.
template <class Cost> struct Tile {
    /// Over a side: 1, or in whole numbers 33461.
    static constexpr Cost straight = std::integral<Cost> ? Cost(33461) : Cost(1);
    /// Over a corner: the root of 2, or in whole numbers 47321, very nearly 33461 times it.
    static constexpr Cost diagonal = std::integral<Cost> ? Cost(47321) : Cost(1.4142135623730950488016887242096981L);
};

namespace detail {

/// The dearest cost there is: of a node that was not reached.
template <class Cost>
inline constexpr Cost infinite =
    std::numeric_limits<Cost>::has_infinity ? std::numeric_limits<Cost>::infinity() : std::numeric_limits<Cost>::max();
/// a + b, which stops at the dearest cost instead of starting again at zero.
template <class Cost> [[gnu::always_inline]] constexpr Cost add(Cost a, Cost b) {
    if constexpr (std::integral<Cost>) {
        Cost sum{};
        return __builtin_add_overflow(a, b, &sum) ? infinite<Cost> : sum;
    } else return a + b;
}
/// a + b without a look at the end of the number, which `is_too_dear` has afterwards.
template <class Cost> [[gnu::always_inline]] constexpr Cost add_unchecked(Cost a, Cost b) {
    if constexpr (std::integral<Cost>) return Cost(std::make_unsigned_t<Cost>(a) + std::make_unsigned_t<Cost>(b));
    else return a + b;
}
/// Whether a sum of a and b, neither of which is negative, is the dearest cost there is, or was more than that.
template <class Cost> [[gnu::always_inline]] constexpr bool is_too_dear(Cost a, Cost b, Cost sum) {
    if constexpr (std::integral<Cost>) return b >= infinite<Cost> - a;
    else return !(sum < infinite<Cost>);
}
/// n costs, which stop at the dearest there is.
template <class Cost> constexpr Cost times(std::size_t n, Cost cost) {
    if constexpr (std::integral<Cost>) {
        Cost product{};
        return __builtin_mul_overflow(n, cost, &product) ? infinite<Cost> : product;
    } else return Cost(n) * cost;
}
/// A weight in the number of a search, no more than the dearest cost there is.
template <class Cost, class Weight> [[gnu::always_inline]] constexpr Cost cost_of(const Weight& weight) {
    if constexpr (std::is_integral_v<Cost> && std::is_floating_point_v<Weight>)
        return weight >= Weight(infinite<Cost>) ? infinite<Cost> : Cost(weight);
    else if constexpr (std::is_integral_v<Cost> &&
                       std::numeric_limits<Weight>::digits > std::numeric_limits<Cost>::digits) // none is negative
        return std::uintmax_t(weight) >= std::uintmax_t(infinite<Cost>) ? infinite<Cost> : Cost(weight);
    else return Cost(weight);
}
/// A number for estimates that may be more than any cost: of 64 bits where costs are whole.
template <class Cost>
using Wide = std::conditional_t<std::integral<Cost>,
                                std::conditional_t<std::is_signed_v<Cost>, std::int64_t, std::uint64_t>, Cost>;
/// The number in which a search keeps estimates of this type: that of its costs, or a wider one of the same kind.
template <class Cost, class Estimated>
using Guess =
    std::conditional_t<std::integral<Cost> && std::integral<Estimated> &&
                           std::is_signed_v<Cost> == std::is_signed_v<Estimated> && (sizeof(Estimated) > sizeof(Cost)),
                       Estimated, Cost>;
/// factor times cost, rounded down where the cost is a whole number, so that an estimate never grows by rounding.
template <class Cost> [[gnu::always_inline]] inline Cost scaled(Cost cost, double factor) {
    if constexpr (std::integral<Cost>) {
        const double product = std::floor(double(cost) * factor);
        return product >= double(infinite<Cost>) ? infinite<Cost> : Cost(product);
    } else return Cost(cost * Cost(factor));
}

} // namespace detail
} // namespace ansatz::paths
