// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Functions of quantities: dot, cross, norm, direction, components, sqrt, abs, min, max,
/// is_finite, in. They accept plain vectors (directions, normals) beside vector quantities and
/// compute coefficient by coefficient, so that a loop over bodies vectorises. For whole columns of
/// numbers use Eigen's own array functions on the lanes.

#include <ansatz/core/error.hpp>
#include <ansatz/units/arithmetic.hpp>
#include <ansatz/units/describe.hpp>

#include <cmath>
#include <limits>

namespace ansatz {

// Inside this namespace the overloads below would hide the ones for plain numbers.
using std::abs;
using std::max;
using std::min;
using std::sqrt;

namespace detail {

template <class S, int N, int O1, int O2>
[[gnu::always_inline]] inline S dot_of(const Dense<S, N, 1, O1>& a, const Dense<S, N, 1, O2>& b) {
    const S* pa = a.data();
    const S* pb = b.data();
    if constexpr (N == 2) return pa[0] * pb[0] + pa[1] * pb[1];
    else if constexpr (N == 3) return pa[0] * pb[0] + pa[1] * pb[1] + pa[2] * pb[2];
    else {
        S sum = pa[0] * pb[0];
        for (int i = 1; i < N; ++i) sum += pa[i] * pb[i];
        return sum;
    }
}

template <class S, int N, int O1, int O2>
[[gnu::always_inline]] inline auto cross_of(const Dense<S, N, 1, O1>& a, const Dense<S, N, 1, O2>& b) {
    static_assert(N == 2 || N == 3, "Ansatz units: cross() is for vectors of 2 or 3 components");
    const S* p = a.data();
    const S* q = b.data();
    if constexpr (N == 2) return S(p[0] * q[1] - p[1] * q[0]);
    else return Dense<S, N, 1, O1>(p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]);
}

template <class Unit, class Value> [[gnu::always_inline]] constexpr auto with_unit(const Value& value) {
    return boost::units::quantity<Unit, Value>::from_value(value);
}

/// Evaluates an expression, hands a plain vector through.
template <Expression E>
[[gnu::always_inline]] inline const Plain<E>& plain(const E& e)
    requires std::is_same_v<E, Plain<E>>
{
    return e;
}
template <Expression E> [[gnu::always_inline]] inline Plain<E> plain(const E& e) { return e; }

} // namespace detail

/// \name Dot product
/// Of two vector quantities, of a quantity and a plain vector, of two plain vectors.
///@{

/// \f$ \mathbf a \cdot \mathbf b \f$, in the product of the units.
template <class U1, class U2, class S, int N, int O>
[[gnu::always_inline]] inline auto dot(const boost::units::quantity<U1, detail::Dense<S, N, 1, O>>& a,
                                       const boost::units::quantity<U2, detail::Dense<S, N, 1, O>>& b) {
    return detail::with_unit<detail::UnitProduct<U1, U2>>(detail::dot_of(a.value(), b.value()));
}
template <class U, class S, int N, int O, detail::Expression E>
[[gnu::always_inline]] inline auto dot(const boost::units::quantity<U, detail::Dense<S, N, 1, O>>& a, const E& b) {
    return detail::with_unit<U>(detail::dot_of(a.value(), detail::plain(b)));
}
template <detail::Expression E, class U, class S, int N, int O>
[[gnu::always_inline]] inline auto dot(const E& a, const boost::units::quantity<U, detail::Dense<S, N, 1, O>>& b) {
    return detail::with_unit<U>(detail::dot_of(detail::plain(a), b.value()));
}
template <detail::Expression E1, detail::Expression E2>
[[gnu::always_inline]] inline auto dot(const E1& a, const E2& b) {
    return detail::dot_of(detail::plain(a), detail::plain(b));
}
///@}

/// \name Cross product
/// Three components: a vector. Two components: the scalar `ax*by - ay*bx`, the third component of
/// the vector product in the plane.
///@{

/// \f$ \mathbf a \times \mathbf b \f$, in the product of the units.
template <class U1, class U2, class S, int N, int O>
[[gnu::always_inline]] inline auto cross(const boost::units::quantity<U1, detail::Dense<S, N, 1, O>>& a,
                                         const boost::units::quantity<U2, detail::Dense<S, N, 1, O>>& b) {
    return detail::with_unit<detail::UnitProduct<U1, U2>>(detail::cross_of(a.value(), b.value()));
}
template <class U, class S, int N, int O, detail::Expression E>
[[gnu::always_inline]] inline auto cross(const boost::units::quantity<U, detail::Dense<S, N, 1, O>>& a, const E& b) {
    return detail::with_unit<U>(detail::cross_of(a.value(), detail::plain(b)));
}
template <detail::Expression E, class U, class S, int N, int O>
[[gnu::always_inline]] inline auto cross(const E& a, const boost::units::quantity<U, detail::Dense<S, N, 1, O>>& b) {
    return detail::with_unit<U>(detail::cross_of(detail::plain(a), b.value()));
}
template <detail::Expression E1, detail::Expression E2>
[[gnu::always_inline]] inline auto cross(const E1& a, const E2& b) {
    return detail::cross_of(detail::plain(a), detail::plain(b));
}
///@}

/// |v|^2, the sum of the squared components. Overflows and underflows at half the exponent range.
template <class U, class S, int N, int O>
[[gnu::always_inline]] inline auto squared_norm(const boost::units::quantity<U, detail::Dense<S, N, 1, O>>& v) {
    return detail::with_unit<detail::UnitProduct<U, U>>(detail::dot_of(v.value(), v.value()));
}
/// |v|^2 of a plain vector.
template <detail::Expression E> [[gnu::always_inline]] inline auto squared_norm(const E& v) {
    const auto& p = detail::plain(v);
    return detail::dot_of(p, p);
}

/// |v|, as sqrt(x*x + y*y + z*z): the form that compilers vectorise. Nothing is rescaled, so
/// components beyond the square root of the largest number give infinity: see robust_norm().
template <class U, class S, int N, int O>
[[gnu::always_inline]] inline boost::units::quantity<U, S>
norm(const boost::units::quantity<U, detail::Dense<S, N, 1, O>>& v) {
    return detail::with_unit<U>(S(sqrt(detail::dot_of(v.value(), v.value()))));
}
/// |v| of a plain vector.
template <detail::Expression E> [[gnu::always_inline]] inline auto norm(const E& v) {
    return typename E::Scalar(sqrt(squared_norm(v)));
}

/// The square root, which halves the dimension: the root of an area is a length.
template <class Unit, class Y>
    requires detail::ScalarValue<Y>
[[gnu::always_inline]] inline auto sqrt(const boost::units::quantity<Unit, Y>& q) {
    using Root = typename boost::units::root_typeof_helper<Unit, boost::units::static_rational<2>>::type;
    return detail::with_unit<Root>(Y(sqrt(q.value())));
}

/// The absolute value of a scalar quantity.
template <class Unit, class Y>
    requires detail::ScalarValue<Y>
[[gnu::always_inline]] inline boost::units::quantity<Unit, Y> abs(const boost::units::quantity<Unit, Y>& q) {
    return detail::with_unit<Unit>(Y(abs(q.value())));
}
/// The smaller of two scalar quantities of one unit; the first if they are equal.
template <class Unit, class Y>
    requires detail::ScalarValue<Y>
[[gnu::always_inline]] constexpr boost::units::quantity<Unit, Y> min(const boost::units::quantity<Unit, Y>& a,
                                                                     const boost::units::quantity<Unit, Y>& b) {
    return b.value() < a.value() ? b : a;
}
/// The larger of two scalar quantities of one unit; the first if they are equal.
template <class Unit, class Y>
    requires detail::ScalarValue<Y>
[[gnu::always_inline]] constexpr boost::units::quantity<Unit, Y> max(const boost::units::quantity<Unit, Y>& a,
                                                                     const boost::units::quantity<Unit, Y>& b) {
    return a.value() < b.value() ? b : a;
}

/// True when a number is neither infinite nor NaN.
template <detail::ScalarValue S> [[gnu::always_inline]] inline bool is_finite(const S& s) {
    using std::isfinite;
    return isfinite(s);
}
/// True when every component of a plain vector or matrix is finite.
template <detail::Expression E> [[gnu::always_inline]] inline bool is_finite(const E& e) {
    const auto& m = detail::plain(e);
    bool all = true;
    for (Eigen::Index i = 0; i < m.size(); ++i)
        all = bool(all & is_finite(m.data()[i])); // no early exit: a loop over bodies stays straight
    return all;
}
/// True when a quantity, with all its components, is finite.
template <class Unit, class Value>
[[gnu::always_inline]] inline bool is_finite(const boost::units::quantity<Unit, Value>& q) {
    return is_finite(q.value());
}

namespace detail {

/// The |v|^2 below which the rounding errors of the squares reach |v|.
template <class S> [[gnu::always_inline]] inline constexpr S smallest_square() {
    return std::numeric_limits<S>::min() / std::numeric_limits<S>::epsilon();
}
/// True where |v|^2 is neither so large nor so small that its rounding errors reach |v|.
template <class S> [[gnu::always_inline]] inline bool squares_well(const S& squared) {
    return squared >= smallest_square<S>() && squared <= std::numeric_limits<S>::max();
}

/// What |v|^2 is below where |v| is below a threshold: its square, and not zero where the square of a small one is
/// nothing, or what stands still would count as fast.
template <class Q> auto squared_threshold(const Q& threshold) {
    using Limits = std::numeric_limits<typename Q::value_type>;
    auto square = threshold * threshold;
    if (threshold.value() > 0 && !(square.value() > 0)) square = decltype(square)::from_value(Limits::denorm_min());
    return square;
}

/// The largest component by size; 0 for a vector that has an infinite or a NaN component.
template <class S, int N, int O> S largest(const Dense<S, N, 1, O>& v) {
    S result(0);
    for (int i = 0; i < N; ++i) {
        const S size = abs(v.data()[i]);
        if (!is_finite(size)) return S(0);
        result = max(result, size);
    }
    return result;
}

/// The unit vector along v: false, and nothing written, where there is none. Vectors so short or so
/// long that the sum of squares leaves the range of the scalar are rescaled first.
template <class S, int N, int O>
[[gnu::always_inline]] inline bool unit_vector(const Dense<S, N, 1, O>& v, Dense<S, N, 1, O>& result) {
    const S squared = dot_of(v, v);
    if (squares_well(squared)) {
        result = scaled<Over>(v, S(sqrt(squared)));
        return true;
    }
    const S size = largest(v);
    if (!(size > S(0))) return false;
    const auto near_one = scaled<Over>(v, size);
    result = scaled<Over>(near_one, S(sqrt(dot_of(near_one, near_one))));
    return true;
}

} // namespace detail

/// |v| over the whole range of the scalar: where the sum of squares would overflow or vanish, v is
/// rescaled first. It branches, so a loop with it is not vectorised; elsewhere the same as norm().
template <class U, class S, int N, int O>
[[gnu::always_inline]] inline boost::units::quantity<U, S>
robust_norm(const boost::units::quantity<U, detail::Dense<S, N, 1, O>>& v) {
    const S squared = detail::dot_of(v.value(), v.value());
    const S size = detail::squares_well(squared) ? S(0) : detail::largest(v.value());
    if (!(size > S(0))) return detail::with_unit<U>(S(sqrt(squared)));
    const auto near_one = detail::scaled<detail::Over>(v.value(), size);
    return detail::with_unit<U>(S(size * sqrt(detail::dot_of(near_one, near_one))));
}

/// The unit vector along v, dimensionless and plain, from the shortest to the longest vectors that
/// the scalar can hold.
/// \throws std::invalid_argument where v has no direction: it is zero, or a component is infinite
///         or NaN. Inside a step use direction_or().
template <class U, class S, int N, int O>
inline detail::Dense<S, N, 1, O> direction(const boost::units::quantity<U, detail::Dense<S, N, 1, O>>& v) {
    detail::Dense<S, N, 1, O> result;
    if (!detail::unit_vector(v.value(), result))
        refuse_value("direction", "the vector", v, "a vector has a direction when it is finite and not zero");
    return result;
}

/// The unit vector along v, or the fallback where v has none. Never throws. It branches, so a loop
/// with it is not vectorised; where v cannot be zero, `v / norm(v)` is.
template <class U, class S, int N, int O>
[[gnu::always_inline]] inline detail::Dense<S, N, 1, O>
direction_or(const boost::units::quantity<U, detail::Dense<S, N, 1, O>>& v,
             const std::type_identity_t<detail::Dense<S, N, 1, O>>& fallback) {
    detail::Dense<S, N, 1, O> result;
    if (!detail::unit_vector(v.value(), result)) return fallback;
    return result;
}

/// One component of a vector quantity.
/// \param i 0 for x, 1 for y, 2 for z; not checked
template <class U, class S, int N, int O>
[[gnu::always_inline]] inline boost::units::quantity<U, S>
component(const boost::units::quantity<U, detail::Dense<S, N, 1, O>>& v, int i) {
    return detail::with_unit<U>(v.value().data()[i]);
}
/// The first component.
template <class U, class S, int N, int O>
[[gnu::always_inline]] inline boost::units::quantity<U, S>
x(const boost::units::quantity<U, detail::Dense<S, N, 1, O>>& v) {
    return component(v, 0);
}
/// The second component.
template <class U, class S, int N, int O>
    requires(N > 1)
[[gnu::always_inline]] inline boost::units::quantity<U, S>
y(const boost::units::quantity<U, detail::Dense<S, N, 1, O>>& v) {
    return component(v, 1);
}
/// The third component.
template <class U, class S, int N, int O>
    requires(N > 2)
[[gnu::always_inline]] inline boost::units::quantity<U, S>
z(const boost::units::quantity<U, detail::Dense<S, N, 1, O>>& v) {
    return component(v, 2);
}

/// The plain number (or plain vector) of a quantity in a unit: `in(v, metre_per_second)`; the way
/// out for plots and other libraries. A unit of another dimension does not compile.
template <class Dimension, class System, class Value>
[[gnu::always_inline]] constexpr Value in(const boost::units::quantity<boost::units::unit<Dimension, System>, Value>& q,
                                          const boost::units::unit<Dimension, System>&) {
    return q.value();
}

} // namespace ansatz
