// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `decay(x)`: e to the power of minus x, the same to the bit in every build.
///
/// Damping that does not depend on the frame rate multiplies by exp(-c dt). The standard library's exp may differ in
/// the last bit between compilers, their options and their constant folding, and a state hash would differ with it;
/// this one uses only operations that IEEE 754 defines. Accurate to about one unit in the last place.

#include <ansatz/units/quantity.hpp>

#include <cmath>
#include <concepts>

namespace ansatz {

/// exp(-x) for x >= 0; exactly 1 for 0 and 0 for very large x.
/// \param x dimensionless, not negative
template <class Scalar> Scalar decay(const Scalar& x) {
    static_assert(!std::integral<Scalar>,
                  "Ansatz: decay takes a number with a fraction, e.g. decay(1.0); its answer is between 0 and 1");
    if constexpr (std::integral<Scalar>) return 0;
    else if constexpr (std::same_as<Scalar, float>) return static_cast<float>(decay(double(x)));
    else if constexpr (!std::same_as<Scalar, double>)
        return exp(Scalar(-x)); // a class scalar brings its own exp, found by argument
    else {
        // NOLINTNEXTLINE(misc-redundant-expression): false for what is no number
        if (!(x < 746)) return x == x ? 0 : x;
        // x = k ln 2 + r with |r| <= ln(2)/2, ln 2 in two parts so that k times the first is exact.
        const double k = std::floor(x * 1.4426950408889634 + 0.5);
        const double r = -((x - k * 0.693147180369123816490) - k * 1.90821492927058770002e-10);
        double sum = 1;
        for (int n = 14; n > 0; --n) sum = 1 + sum * r / n; // Taylor's series, by Horner: |r|^15/15! < 1e-19
        return std::ldexp(sum, -int(k));
    }
}

/// The same of a quantity without a dimension, such as a rate times a time; any other is refused.
template <class Scalar, class Unit> Scalar decay(const boost::units::quantity<Unit, Scalar>& x) {
    constexpr bool pure_number = detail::is_dimensionless_unit<Unit>;
    static_assert(pure_number,
                  "Ansatz: decay takes a pure number; a rate becomes one by a time, e.g. decay(rate * dt)");
    if constexpr (pure_number) return decay(x.value());
    else return Scalar(0);
}

} // namespace ansatz
