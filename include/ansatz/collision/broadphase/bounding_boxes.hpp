// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `BoundingBoxes`: all pairs, and the box test for each (notes 2.1.1, "Bounding Box Test").
///
/// Still \f$ N^2 \f$ tests, but each is a few comparisons of numbers that lie in a row. Use it for a handful of bodies
/// whose shapes are dear to compare; for spheres AllPairs is no slower, and SortAndSweep is faster from a few dozen on.
/// It is the definition of what the other broadphases must find, and the usual test inside their cells.
/// <!-- costs: collision broadphase/uniform: SortAndSweep < BoundingBoxes from 64; collision broadphase/uniform:
/// AllPairs < 1.05 BoundingBoxes -->

#include <ansatz/collision/broadphase/inside.hpp>
#include <ansatz/world/space.hpp>

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace ansatz {

/// Each pair whose boxes touch, by testing every pair.
struct BoundingBoxes {
    using role = roles::Broadphase;
    static constexpr bool takes_any_order = true; ///< lists of cells may be joined

    static constexpr std::string_view name = "BoundingBoxes";
    static void parameters(auto&, auto&&) {}

    template <class S> class In {
    public:
        explicit In(const BoundingBoxes&) {}
        template <class F> void find(const Boxes<S>& boxes, F&& found) {
            for (std::size_t i = 0; i < boxes.active(); ++i)
                scan(boxes, i, i + 1, boxes.size(), [&](std::size_t j) { found(i, j); });
        }
        /// \name Inside a cell
        /// @{
        const std::uint32_t* order(const Boxes<S>&) { return nullptr; }
        void arrange(Lot<S>&, std::size_t, std::size_t) {}
        template <class F>
        [[gnu::always_inline]] void among(const Lot<S>& lot, std::size_t first, std::size_t last, F&& touch) const {
            for (std::size_t p = first; p < last; ++p) scan(lot, p, p + 1, last, [&](std::size_t q) { touch(p, q); });
        }
        template <class F>
        [[gnu::always_inline]] void between(const Lot<S>& lot, std::size_t first, std::size_t last,
                                            std::size_t other_first, std::size_t other_last, F&& touch) const {
            for (std::size_t p = first; p < last; ++p)
                scan(lot, p, other_first, other_last, [&](std::size_t q) { touch(p, q); });
        }
        /// @}
    };
};

} // namespace ansatz
