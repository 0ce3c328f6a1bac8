// SPDX-License-Identifier: BSL-1.0
#pragma once

// Mistake: what is taken off left over
// Why:     exp(-c dt) is the part of the velocity that is left. v -= v * factor takes just that part away: without
//          any drag the body would stop at once.
// Read:    1.7
// Fails:   factor, only-slower, no-drag, float

#include <ansatz/world.hpp>

using namespace ansatz;

namespace exercise {

/// 1.7: the velocity falls at the rate c, dv/dt = -c v, in every step after the integrator.
struct Drag {
    using role = roles::Effect;
    using writes = Columns<Velocity>;
    static constexpr Place place = Place::after_integration;

    Parameter<unit::Frequency> rate = 0.05 / second; ///< c; zero is no drag

    /// The same in a space S, for example Space<float, 2>; S::Scalar is the type of its numbers.
    template <class S> struct In {
        typename S::template ScalarOf<unit::Frequency> rate;
        typename S::Scalar factor{1};

        explicit In(const Drag& drag) : rate(S::convert(drag.rate)) {}

        /// Once in each step: compute the factor. context.dt() is the length of the step.
        void prepare(const auto& context) { factor = decay<typename S::Scalar>(rate * context.dt()); }
        /// For each body: change its velocity.
        void apply(typename S::Velocity& v, const auto&) const { v -= v * factor; }
    };
};

/// The rate at which Drag slows down as much as a factor in each of so many frames a second; 0 < factor <= 1.
inline Quantity<unit::Frequency> rate_of(double factor, Quantity<unit::Frequency> frames) {
    return -std::log(factor) * frames;
}

} // namespace exercise
