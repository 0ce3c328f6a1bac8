// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Box`: a box along the axes; a rectangle in two dimensions.
///
/// Bodies are points without rotation here, so that a box never turns: use it for walls, crates on a grid, and areas
/// that notice what enters. Two boxes touch along one axis only; a corner is never rounded off.

#include <ansatz/core/error.hpp>
#include <ansatz/units.hpp>

#include <string>
#include <string_view>

namespace ansatz {

/// All points whose distance from the position is no more than `half` on each axis.
struct Box {
    using shape = Box;                    ///< it is a shape
    static constexpr bool bounded = true; ///< a box holds it

    /// m, half of its length on each axis, finite and greater than zero: `Box{metres(0.5, 0.5, 0.5)}` has edges of 1 m.
    /// Two of them for a world of two dimensions.
    VectorParameter<unit::Length> half;

    static constexpr std::string_view name = "Box";
    static void parameters(auto& self, auto&& visit) { visit("half", self.half); }

    /// In the scalar of a space.
    template <class S> struct In {
        using description = Box;   ///< what it was made from
        typename S::Position half; ///< m
        /// \throws std::invalid_argument for a half length that is not finite and greater than zero, and for another
        /// number of them
        ///         than the space has dimensions
        explicit In(const Box& box) : half(S::convert("Box::half", box.half)) {
            for (int k = 0; k < S::dimension; ++k)
                if (!is_finite(half) || !(half.value()[k] > 0))
                    refuse_value("Box", "half", box.half,
                                 S::dimension == 2 ? "two lengths, finite and greater than zero"
                                                   : "three lengths, finite and greater than zero");
        }

        /// One whose faces are further out by this; its corners are further out than that.
        In grown(const typename S::Length& by) const {
            In larger(*this);
            auto h = half.value();
            for (int k = 0; k < S::dimension; ++k) h[k] += by.value();
            larger.half = S::Position::from_value(h);
            return larger;
        }
        /// The corners of its bounding box, at position `x`.
        [[gnu::always_inline]] void bounds(const typename S::Position& x, typename S::Position& lower,
                                           typename S::Position& upper) const {
            lower = x - half;
            upper = x + half;
        }
    };
};

} // namespace ansatz
