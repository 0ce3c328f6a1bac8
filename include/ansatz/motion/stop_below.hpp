// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `StopBelow`: a velocity close to zero is set to zero, to the letter of the notes (notes 1.8).
///
/// Use it to see what the rule does, or in a scene without forces. Under gravity it stops a ball at the top of its
/// flight: where one step adds less than the threshold (g dt < threshold) the ball goes on by no more than g dt^2 in a
/// step, for ever. And it saves no work, since the body is computed in the next step all the same. rest.hpp is the
/// rule made safe.

#include <ansatz/motion/concepts.hpp>
#include <ansatz/units/requirements.hpp>

#include <string_view>

namespace ansatz {

/// \f$ |\mathbf v| < v_{min} \Rightarrow \mathbf v \leftarrow 0 \f$, after the integrator.
struct StopBelow {
    using role = roles::Effect;
    using writes = Columns<Velocity>;
    static constexpr Place place = Place::after_integration;
    static constexpr int turn = 1; ///< after all damping

    /// m/s, finite, not negative; zero stops nothing
    Parameter<unit::Velocity> threshold = 0.05 * metre_per_second;

    static constexpr std::string_view name = "StopBelow";
    static void parameters(auto& self, auto&& visit) { visit("threshold", self.threshold); }
    void check() const { require_not_negative("StopBelow", "threshold", threshold); }

    template <class S> struct In {
        typename S::template ScalarOf<unit::SpecificEnergy> limit; ///< of |v|^2
        explicit In(const StopBelow& stop)
            : limit(detail::squared_threshold<typename S::Speed>(S::convert(stop.threshold))) {}

        [[gnu::always_inline]] void apply(typename S::Velocity& v, const auto&) const {
            const bool slow = squared_norm(v) < limit;
            auto components = v.value();
            for (int i = 0; i < S::dimension; ++i) components[i] = slow ? typename S::Scalar(0) : components[i];
            v = S::Velocity::from_value(components);
        }
    };
};

} // namespace ansatz
