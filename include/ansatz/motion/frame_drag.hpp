// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `FrameDrag`: the notes' damping factor 0 < d < 1 for each frame (notes 1.7).
///
/// Use it to see what the notes describe, in a program whose step never changes. It depends on the frame rate: "times
/// 0.99 in each frame" leaves 74 % of a velocity after a second at 30 Hz, 55 % at 60 Hz and 30 % at 120 Hz. drag.hpp is
/// the same thing without that.

#include <ansatz/motion/concepts.hpp>
#include <ansatz/units/requirements.hpp>

#include <string_view>

namespace ansatz {

/// \f$ \mathbf v \leftarrow d\,\mathbf v \f$ in every step, after the integrator.
struct FrameDrag {
    using role = roles::Effect;
    using writes = Columns<Velocity>;
    static constexpr Place place = Place::after_integration;

    /// d, dimensionless, above 0 and at most 1; 1 is no drag, to the bit
    Parameter<unit::Dimensionless> factor = 0.99;

    static constexpr std::string_view name = "FrameDrag";
    static void parameters(auto& self, auto&& visit) { visit("factor", self.factor); }
    void check() const {
        if (!(factor.value() > 0) || !(factor.value() <= 1))
            refuse_value("FrameDrag", "factor", factor, "a damping factor is above 0 and at most 1 (1 damps nothing)");
    }

    template <class S> struct In {
        typename S::Scalar factor;
        explicit In(const FrameDrag& drag) : factor(static_cast<typename S::Scalar>(drag.factor.value())) {}

        [[gnu::always_inline]] void apply(typename S::Velocity& v, const auto&) const { v *= factor; }
    };
};

} // namespace ansatz
