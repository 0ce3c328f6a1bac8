// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What tests the bodies inside a cell of a partition: the concept of the parameter of `UniformGrid`, `Octree` and
/// `BinarySplit` (notes 2.1.1: sort and sweep "can be used in conjunction with any other method").
///
/// `BoundingBoxes` and `SortAndSweep` are such, so that `Octree<SortAndSweep>` is an octree whose cells are sorted
/// along an axis. Their `In<S>` has four verbs besides `find`:
///
/// - `order(boxes)`: in which order the bodies are handed out to the cells: a pointer to as many indices as there are
/// boxes,
///   or nullptr for their own. What is sorted here arrives sorted in every cell.
/// - `arrange(lot, first, last)`: called once for each list of a cell, before it is tested.
/// - `among(lot, first, last, touch)`: calls `touch(p, q)` for the places of each two in a list whose boxes touch.
/// - `between(lot, first, last, other_first, other_last, touch)`: the same, of one list and another.

#include <ansatz/collision/broadphase/broadphase.hpp>
#include <ansatz/collision/broadphase/lot.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>

namespace ansatz {

/// A broadphase that can test what is inside a cell: `BoundingBoxes` and `SortAndSweep` can (notes 2.1.1).
template <class P, class S>
concept InsideIn = BroadphaseIn<P, S> &&
                   requires(typename P::template In<S>& bound, const Boxes<S>& boxes, Lot<S>& lot, std::size_t n) {
                       { bound.order(boxes) } -> std::convertible_to<const std::uint32_t*>;
                       bound.arrange(lot, n, n);
                       bound.among(lot, n, n, detail::PairProbe());
                       bound.between(lot, n, n, n, n, detail::PairProbe());
                   };

namespace detail {
/// Whether lists may be joined before they are tested, because their order does not matter.
template <class P> inline constexpr bool takes_any_order = false;
template <class P>
    requires requires { P::takes_any_order; }
inline constexpr bool takes_any_order<P> = P::takes_any_order;
/// Whether it tests lists without changing what it keeps, so that several threads may ask it.
template <class P, class S>
inline constexpr bool searches_unchanged =
    requires(const typename P::template In<S>& bound, const Lot<S>& lot, std::size_t n) {
        bound.among(lot, n, n, PairProbe());
        bound.between(lot, n, n, n, n, PairProbe());
    };
} // namespace detail

} // namespace ansatz
