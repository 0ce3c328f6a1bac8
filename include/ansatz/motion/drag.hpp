// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Drag`: damping of the velocity that does not depend on the frame rate (notes 1.7, made right).
///
/// Use it for the cheap "everything comes to a stop in the end" of the notes: in every second the velocity falls by the
/// same factor exp(-c * 1 s), whether that second has 30 steps or 240. Stable for any coefficient and any step, because
/// it multiplies instead of pushing. Not a model of air: the resistance of air grows with the square of the speed
/// (quadratic_drag.hpp). The notes' own form, a factor for each frame, is frame_drag.hpp.

#include <ansatz/motion/concepts.hpp>
#include <ansatz/motion/decay.hpp>
#include <ansatz/units/requirements.hpp>

#include <string_view>

namespace ansatz {

/// \f$ \mathbf v \leftarrow \mathbf v\, e^{-c\,\Delta t} \f$, after the integrator.
struct Drag {
    using role = roles::Effect;
    using writes = Columns<Velocity>;
    static constexpr Place place = Place::after_integration;

    /// c in 1/s, finite, not negative; zero is no drag, to the bit
    Parameter<unit::Frequency> rate = 0.05 / second;

    static constexpr std::string_view name = "Drag";
    static void parameters(auto& self, auto&& visit) { visit("rate", self.rate); }
    void check() const { require_not_negative("Drag", "rate", rate); }

    template <class S> struct In {
        typename S::template ScalarOf<unit::Frequency> rate;
        typename S::Scalar factor{1};

        explicit In(const Drag& drag) : rate(S::convert(drag.rate)) {}

        void prepare(const auto& context) { factor = decay(typename S::Scalar(rate.value() * context.dt().value())); }
        [[gnu::always_inline]] void apply(typename S::Velocity& v, const auto&) const { v *= factor; }
    };
};

} // namespace ansatz
