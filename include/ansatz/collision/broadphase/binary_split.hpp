// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `BinarySplit`: the world divided in two along its longest axis, at the middle body, and each half again
/// (notes 2.1.1, "Binary Search Partitioning").
///
/// The plane lies where half of the bodies are on either side, so that N bodies are ten levels deep for each factor of
/// a thousand, wherever they are: crowds at unlike scales, which an Octree needs many divisions to reach, are reached
/// at once. In the scenes that are measured an Octree is faster. <!-- costs: collision broadphase/*: BinarySplit >
/// Octree from 64 --> (This is a k-d tree: J. L. Bentley, "Multidimensional binary search trees used for associative
/// searching", 1975.)

#include <ansatz/collision/broadphase/bounding_boxes.hpp>
#include <ansatz/collision/broadphase/recursion.hpp>
#include <ansatz/collision/broadphase/sort_and_sweep.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace ansatz {

/// The pairs whose boxes touch, by halving the bodies.
/// \tparam Inside what tests the bodies of a cell: BoundingBoxes or SortAndSweep
template <class Inside = BoundingBoxes> struct BinarySplit {
    using role = roles::Broadphase;
    template <class S> static constexpr bool tests_inside = InsideIn<Inside, S>; ///< whether `Inside` can

    /// A cell with more bodies is divided; at least 1
    int threshold = 24;
    /// How often a cell may be divided; 0 to 64
    int depth = 32;
    /// What tests the bodies of a cell
    Inside inside{};

    static constexpr std::string_view name = "BinarySplit";
    static void parameters(auto&, auto&&) {}
    void check() const {
        if (threshold < 1)
            refuse_value("BinarySplit", "threshold", std::to_string(threshold), "a cell holds at least 1 body");
        if (depth < 0 || depth > 64)
            refuse_value("BinarySplit", "depth", std::to_string(depth), "it is 0 to 64 divisions");
    }

    template <class S> class In {
        using Scalar = typename S::Scalar;

    public:
        explicit In(const BinarySplit& split)
            : threshold_(std::size_t(split.threshold)), depth_(split.depth), recursion_(split.inside) {}
        /// Room for so many boxes.
        void reserve(std::size_t n) { recursion_.reserve(n); }
        template <class F> void find(const Boxes<S>& boxes, F&& found) {
            constexpr double copies = 1.4; // two halves of 0.7 of the bodies are as much work as all of them in one
            auto divide = [&](const detail::TreeCell<S>& cell, const std::uint32_t* members, std::size_t count,
                              int attempt, detail::Division<S>& division) {
                return middle_body(boxes, cell, members, count, attempt, division);
            };
            recursion_.find(boxes, threshold_, depth_, copies, divide, found);
        }

    private:
        static constexpr std::size_t dimension = std::size_t(S::dimension);

        /// The longest axis first; where that is of no use, the next.
        static bool middle_body(const Boxes<S>& boxes, const detail::TreeCell<S>& cell, const std::uint32_t* members,
                                std::size_t count, int attempt, detail::Division<S>& division) {
            if (attempt >= S::dimension) return false;
            std::array<std::size_t, dimension> axes;
            std::array<Scalar, dimension> widths;
            for (std::size_t k = 0; k < dimension; ++k) {
                const Scalar half = cell.upper[k] / 2 - cell.lower[k] / 2;
                axes[k] = k, widths[k] = half > Scalar(0) ? half : Scalar(0); // no order has a NaN in it
            }
            std::sort(axes.begin(), axes.end(), [&](std::size_t a, std::size_t b) {
                return widths[b] < widths[a] || (widths[a] == widths[b] && a < b);
            });
            const std::size_t axis = axes[std::size_t(attempt)];
            const Scalar at = middle_of(boxes, int(axis), members, count);
            division.axes = cell.lower[axis] < at && at < cell.upper[axis] ? 1u << axis : 0u;
            division.at[axis] = at;
            return true;
        }
        /// The middle one of the centres, of so many of them that it hardly matters which.
        static Scalar middle_of(const Boxes<S>& boxes, int axis, const std::uint32_t* members, std::size_t count) {
            constexpr std::size_t most = 31;
            std::array<Scalar, most> centres;
            const std::size_t taken = std::min(count, most);
            for (std::size_t n = 0; n < taken; ++n) {
                const std::uint32_t i = members[n * count / taken];
                const Scalar centre = boxes.lower(axis)[i] / 2 + boxes.upper(axis)[i] / 2;
                // NOLINTNEXTLINE(misc-redundant-expression): false for what is no number
                centres[n] = centre == centre ? centre : Scalar(0); // nor has this one
            }
            const auto middle = centres.begin() + std::ptrdiff_t(taken / 2);
            std::nth_element(centres.begin(), middle, centres.begin() + std::ptrdiff_t(taken));
            return *middle;
        }

        std::size_t threshold_;
        int depth_;
        detail::Recursion<S, Inside> recursion_;
    };
};

} // namespace ansatz
