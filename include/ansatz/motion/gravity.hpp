// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Gravity`: a constant acceleration, the same for every mass (notes 1.9).
///
/// Use it near the surface of something large, and vary it as the notes do for a cheap change of environment
/// (`world.set(Gravity{metres_per_second_squared(0, -1.62, 0)})` is the moon). Not for bodies that attract each other
/// or a centre: the acceleration then depends on the place; see attraction.hpp.

#include <ansatz/motion/concepts.hpp>
#include <ansatz/units/requirements.hpp>

#include <string_view>

namespace ansatz {

/// \f$ \mathbf a = \mathbf g \f$, with g = (0, -9.81, 0) m/s^2 unless another is given.
struct Gravity {
    using role = roles::Force;
    using reads = Columns<>;

    /// m/s^2; in a world of two dimensions the third component must be zero
    VectorParameter<unit::Acceleration> acceleration = metres_per_second_squared(0, -9.81, 0);

    static constexpr std::string_view name = "Gravity";
    static void parameters(auto& self, auto&& visit) { visit("acceleration", self.acceleration); }
    void check() const { require_finite("Gravity", "acceleration", acceleration); }

    template <class S> struct In {
        typename S::Acceleration g;
        explicit In(const Gravity& gravity) : g(S::convert("Gravity::acceleration", gravity.acceleration)) {}

        [[gnu::always_inline]] typename S::Acceleration acceleration(const auto&) const { return g; }

        /// Potential energy for each kilogram, -g.x (m^2/s^2); zero at the origin.
        auto potential(const typename S::Position& x, const auto&) const { return -dot(g, x); }
    };
};

} // namespace ansatz
