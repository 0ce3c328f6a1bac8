// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `AllPairs`: every pair, without a test of boxes (notes 2.1).
///
/// The \f$ N^2 \f$ problem that the notes start from, and what every other broadphase is measured by. Use it for a handful
/// of bodies, or to see what the others save. It has no box test: what it tells is not the set that the others agree
/// on.

#include <ansatz/collision/broadphase/broadphase.hpp>
#include <ansatz/world/space.hpp>

#include <cstddef>
#include <string_view>

namespace ansatz {

/// \f$ N (N - 1) / 2 \f$ pairs, less those of two bodies that do not move.
struct AllPairs {
    using role = roles::Broadphase;
    static constexpr bool needs_boxes = false; ///< only their number counts

    static constexpr std::string_view name = "AllPairs";
    static void parameters(auto&, auto&&) {}

    template <class S> class In {
    public:
        explicit In(const AllPairs&) {}
        template <class F> void find(const Boxes<S>& boxes, F&& found) {
            for (std::size_t i = 0; i < boxes.active(); ++i)
                for (std::size_t j = i + 1; j < boxes.size(); ++j) found(i, j);
        }
    };
};

} // namespace ansatz
