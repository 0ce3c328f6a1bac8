// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Octree`: the world's cube divided into eight, and each that holds too many bodies again (notes 2.1.1, "Binary
/// Search Partitioning"). In two dimensions it is a quadtree.
///
/// Use it where bodies are of mixed sizes: small cells are made only where they are needed. Where they are of one size,
/// in crowds, too, UniformGrid is faster. <!-- costs: collision broadphase/uniform: UniformGrid < Octree from 256;
/// collision broadphase/clustered: UniformGrid < Octree from 256; collision broadphase/mixed: Octree < UniformGrid from
/// 1024 --> The notes' warning is a real one: the `threshold` must be
/// chosen. Above the number of bodies it is `Inside` alone; at one or two most of the time goes into dividing, and
/// bodies that reach over many planes are copied into many cells. chapters/2-collision/2.1.1.3 shows both ends.

#include <ansatz/collision/broadphase/bounding_boxes.hpp>
#include <ansatz/collision/broadphase/recursion.hpp>
#include <ansatz/collision/broadphase/sort_and_sweep.hpp>

#include <cstddef>
#include <string>
#include <string_view>

namespace ansatz {

/// The pairs whose boxes touch, by halving cubes.
/// \tparam Inside what tests the bodies of a cell: BoundingBoxes or SortAndSweep
template <class Inside = BoundingBoxes> struct Octree {
    using role = roles::Broadphase;
    template <class S> static constexpr bool tests_inside = InsideIn<Inside, S>; ///< whether `Inside` can

    /// A cell with more bodies is divided; at least 1
    int threshold = 24;
    /// How often a cell may be divided; 0 to 64. A cube is 1/2^depth of the world's wide at the least
    int depth = 16;
    /// What tests the bodies of a cell
    Inside inside{};

    static constexpr std::string_view name = "Octree";
    static void parameters(auto&, auto&&) {}
    void check() const {
        if (threshold < 1)
            refuse_value("Octree", "threshold", std::to_string(threshold), "a cell holds at least 1 body");
        if (depth < 0 || depth > 64) refuse_value("Octree", "depth", std::to_string(depth), "it is 0 to 64 divisions");
    }

    template <class S> class In {
        using Scalar = typename S::Scalar;

    public:
        explicit In(const Octree& octree)
            : threshold_(std::size_t(octree.threshold)), depth_(octree.depth), recursion_(octree.inside) {}
        /// Room for so many boxes.
        void reserve(std::size_t n) { recursion_.reserve(n); }
        template <class F> void find(const Boxes<S>& boxes, F&& found) {
            // A child holds a quarter of its bodies when the eight hold twice as many: still half of the work.
            constexpr double copies = 2;
            recursion_.find(boxes, threshold_, depth_, copies, halves, found);
        }

    private:
        /// A cube has one width: an axis along which the world is shorter is divided as soon as the cubes are as small.
        static bool halves(const detail::TreeCell<S>& cell, const std::uint32_t*, std::size_t, int attempt,
                           detail::Division<S>& division) {
            if (attempt > 0) return false;
            Scalar widest(0);
            for (std::size_t k = 0; k < std::size_t(S::dimension); ++k) {
                const Scalar width =
                    cell.upper[k] / 2 - cell.lower[k] / 2; // by halves: the whole may be too large for the scalar
                if (widest < width) widest = width;
            }
            division.axes = 0;
            for (std::size_t k = 0; k < std::size_t(S::dimension); ++k) {
                const Scalar middle = cell.lower[k] / 2 + cell.upper[k] / 2;
                if (!(cell.lower[k] < middle && middle < cell.upper[k])) continue; // too narrow for its numbers
                if (cell.upper[k] / 2 - cell.lower[k] / 2 < widest * Scalar(0.75)) continue;
                division.axes |= 1u << k;
                division.at[k] = middle;
            }
            return true;
        }

        std::size_t threshold_;
        int depth_;
        detail::Recursion<S, Inside> recursion_;
    };
};

} // namespace ansatz
