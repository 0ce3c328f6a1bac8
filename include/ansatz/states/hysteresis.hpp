// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Hysteresis: a band between two thresholds instead of one threshold (notes 5.2, state oscillations).
///
/// `constexpr auto warm = band(value("temperature", &Room::t), 20.0, 0.5);` and then `when(warm.above())` on the way up
/// and `when(warm.below())` on the way down. The value must cross the whole band to be answered again, so that noise,
/// or the behaviour of the state itself, does not throw the machine back and forth. With normal noise of standard
/// deviation
/// \f$\sigma\f$ around the threshold and a band of half-width \f$w\sigma\f$, one sample in \f$ 2 / \mathrm{erfc}(w/\sqrt2) \f$
/// turns the machine. The band costs nothing and remembers nothing: the state is its memory. What it cannot do is make
/// a slow actuator fast: a follower that overshoots further than the band still oscillates (see oscillation.hpp).

#include <ansatz/states/values.hpp>

namespace ansatz::states {

/// Two thresholds around a value.
template <class Read, class Limit> struct Band {
    Value<Read> value; ///< what is compared
    Limit low;         ///< the lower threshold, in the unit of the value
    Limit high;        ///< the upper one

    /// The guard of the way up: the value is above the whole band.
    constexpr Compared<Read, Limit> above() const { return {value, Comparison::greater, high}; }
    /// The guard of the way down: the value is below the whole band.
    constexpr Compared<Read, Limit> below() const { return {value, Comparison::less, low}; }
};

/// A band around a threshold.
/// \param half_width  in the threshold's unit, not negative; 0 is the single threshold that oscillates
/// \throws std::invalid_argument for a negative or non-finite width (in a constant expression it does not compile)
template <class R, class L> constexpr Band<R, L> band(Value<R> v, L threshold, L half_width) {
    const auto number = detail::number_of(half_width);
    if (!(number >= 0) || !(number <= std::numeric_limits<decltype(number)>::max()))
        refuse_value("band", "half_width", detail::text_of(half_width),
                     "half the width of a band of hysteresis is finite and not negative");
    return {v, threshold - half_width, threshold + half_width};
}

} // namespace ansatz::states
