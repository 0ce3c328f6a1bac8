// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What a broadphase is (notes 2.1.1): the concept, and `find_pairs`, for boxes without a World.
///
/// A broadphase is a policy with the role Broadphase. It knows no Space; `In<S>`, made from it, has the verb:
///
/// \code
/// template <class F> void find(const Boxes<S>& boxes, F&& found);   // found(i, j) for each pair, i < j
/// \endcode
///
/// Each pair of boxes that touch is told exactly once, where one of the two at least belongs to a body that moves
/// (`i < boxes.active()`), in an order that depends on the boxes alone. `In<S>` keeps its working memory; once warm it
/// allocates nothing. The boxes are finite, which `Boxes::check` says; of others `find` may miss any pair, and no more.
///
/// One whose search can be divided among the threads of an Execution has three verbs more (`DividedBroadphaseIn`):
///
/// \code
/// void prepare(const Boxes<S>& boxes, const auto& run);   // what is done once; loops by run(count, grain, loop)
/// std::size_t pieces() const;                             // into how many the search is divided
/// template <class F> void find(const Boxes<S>& boxes, std::size_t first, std::size_t last, F&& found) const;
/// \endcode
///
/// The second `find` tells the pairs of the pieces first to last - 1, on several threads at the same time: together all
/// pairs, each of them once. It may have a fourth, `finish(pairs)`, which is told behind them how many pairs there
/// were.

#include <ansatz/collision/boxes.hpp>
#include <ansatz/collision/roles.hpp>
#include <ansatz/world/execution.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <utility>
#include <vector>

namespace ansatz {

namespace detail {
struct PairProbe {
    void operator()(std::size_t, std::size_t) const {}
};
template <class P, class S>
concept BindsBroadphase =
    requires { typename P::template In<S>; } && std::constructible_from<typename P::template In<S>, const P&>;
template <class P, class S>
concept FindsPairs = BindsBroadphase<P, S> && requires(typename P::template In<S>& bound, const Boxes<S>& boxes) {
    bound.find(boxes, PairProbe());
};
/// Whether it uses boxes at all; one that does not says `static constexpr bool needs_boxes = false;`.
template <class P> inline constexpr bool needs_boxes = true;
template <class P>
    requires requires { P::needs_boxes; }
inline constexpr bool needs_boxes<P> = P::needs_boxes;
} // namespace detail

/// A broadphase in space `S`: plays the role, `In<S>` is made from it, and that has `find(boxes, found)`.
///
/// `AllPairs`, `BoundingBoxes`, `UniformGrid`, `Octree`, `BinarySplit`, `SortAndSweep` and `Coherent` are such (notes
/// 2.1.1).
template <class P, class S>
concept BroadphaseIn = PlaysRole<P, roles::Broadphase> && detail::FindsPairs<P, S>;

namespace detail {
template <class P, class S>
concept FindsInPieces = requires(typename P::template In<S>& bound, const typename P::template In<S>& prepared,
                                 const Boxes<S>& boxes, std::size_t n) {
    bound.prepare(boxes, Serially());
    { prepared.pieces() } -> std::convertible_to<std::size_t>;
    prepared.find(boxes, n, n, PairProbe());
};
} // namespace detail

/// A broadphase whose search the Execution of a world divides: it has `prepare`, `pieces` and a `find` of some of them.
///
/// `UniformGrid` and `Coherent` are such. The search of another one is serial; what is done with its pairs is not. So
/// is that of one which is derived from such a one and has a `find` of its own, which hides the other. Say
/// `static_assert(DividedBroadphaseIn<MyBroadphase, Space<>>)` where yours is meant to be divided.
template <class P, class S>
concept DividedBroadphaseIn = BroadphaseIn<P, S> && detail::FindsInPieces<P, S>;

namespace detail {
/// What tests the bodies inside a cell, for a partition that has such a policy: the partition says so itself.
template <class P, class S> inline constexpr bool tests_inside = true;
template <class P, class S>
    requires requires { P::template tests_inside<S>; }
inline constexpr bool tests_inside<P, S> = P::template tests_inside<S>;

template <class P, class S> struct BroadphaseFacts {
    static constexpr bool plays = PlaysRole<P, roles::Broadphase>;
    static constexpr bool inside = !plays || tests_inside<P, S>;
    static constexpr bool binds = !plays || !inside || BindsBroadphase<P, S>;
    static constexpr bool finds = !plays || !inside || !binds || FindsPairs<P, S>;
    static constexpr bool ok = plays && inside && binds && finds;
};
template <class P, class S> struct CheckBroadphase {
    using Facts = BroadphaseFacts<P, S>;
    static_assert(Facts::plays, "Ansatz: this is no broadphase; one says `using role = roles::Broadphase;`");
    static_assert(Facts::inside,
                  "Ansatz: what tests the bodies inside a cell is BoundingBoxes or SortAndSweep, or has the verbs of "
                  "InsideIn; write e.g. Octree<SortAndSweep>");
    static_assert(Facts::binds, "Ansatz: a broadphase that cannot be bound to a space; it needs `template <class S> "
                                "class In` with a constructor "
                                "from the policy, `explicit In(const MyBroadphase&)`");
    static_assert(Facts::finds, "Ansatz: a broadphase with a wrong signature; its In<S> needs `template <class F> void "
                                "find(const Boxes<S>& boxes, "
                                "F&& found)`, which calls found(i, j) for each pair");
};
} // namespace detail

/// The same as sentences, one for each thing that can be wrong.
template <class P, class S> consteval bool check_broadphase() {
    static_assert(sizeof(detail::CheckBroadphase<P, S>) > 0);
    return detail::BroadphaseFacts<P, S>::ok;
}

/// A pair of boxes, by their indices; the first is the smaller.
using IndexPair = std::pair<std::size_t, std::size_t>;

/// The pairs of boxes that a broadphase finds, sorted. For each step of a loop keep an `In<S>` of your own instead,
/// which allocates nothing.
/// \throws std::invalid_argument for a parameter that its `check` refuses, and for boxes that are not finite
template <class P, class S> std::vector<IndexPair> find_pairs(const P& broadphase, const Boxes<S>& boxes) {
    std::vector<IndexPair> pairs;
    if constexpr (check_broadphase<P, S>()) {
        if constexpr (requires { broadphase.check(); }) broadphase.check();
        boxes.check("find_pairs");
        typename P::template In<S> bound(broadphase);
        bound.find(boxes, [&](std::size_t i, std::size_t j) { pairs.emplace_back(i, j); });
        std::sort(pairs.begin(), pairs.end());
    }
    return pairs;
}

} // namespace ansatz
