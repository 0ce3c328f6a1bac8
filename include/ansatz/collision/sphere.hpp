// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Sphere`: a ball around a body's position; a disc in two dimensions (notes 2.1.2).
///
/// The simplest shape there is, and the one whose contacts are exact: use it for balls, and as a first approximation of
/// anything that is about as wide as it is high.

#include <ansatz/units.hpp>
#include <ansatz/units/requirements.hpp>

#include <string_view>

namespace ansatz {

/// All points no further than `radius` from the position.
struct Sphere {
    using shape = Sphere;                 ///< it is a shape
    static constexpr bool bounded = true; ///< a box holds it

    /// r, m, finite and greater than zero
    Parameter<unit::Length> radius;

    static constexpr std::string_view name = "Sphere";
    static void parameters(auto& self, auto&& visit) { visit("radius", self.radius); }
    /// \throws std::invalid_argument for a radius that is not finite and greater than zero
    void check() const { require_positive("Sphere", "radius", radius); }

    /// In the scalar of a space.
    template <class S> struct In {
        using description = Sphere; ///< what it was made from
        typename S::Length radius;  ///< m
        /// \throws std::invalid_argument for a radius that is nothing, or too much, in the scalar of the space
        explicit In(const Sphere& sphere) : radius(S::convert(sphere.radius)) {
            if (!(radius.value() > 0))
                refuse_value("Sphere", "radius", sphere.radius, "it is greater than zero in the world's scalar");
        }
        static constexpr bool grows_evenly = true; ///< grown by d it is exactly what is within d of it
        /// A larger one.
        [[gnu::always_inline]] In grown(const typename S::Length& by) const {
            In larger(*this);
            larger.radius += by;
            return larger;
        }

        /// The corners of its bounding box, at position `x`.
        [[gnu::always_inline]] void bounds(const typename S::Position& x, typename S::Position& lower,
                                           typename S::Position& upper) const {
            auto low = x.value(), high = x.value();
            for (int k = 0; k < S::dimension; ++k) {
                low[k] -= radius.value();
                high[k] += radius.value();
            }
            lower = S::Position::from_value(low);
            upper = S::Position::from_value(high);
        }
    };
};

} // namespace ansatz
