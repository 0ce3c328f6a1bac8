// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `first_touch` and `impact`: when two bodies that move in a step first touch, in closed form (notes 2.1.2, a step too
/// large).
///
/// Only the motion of one seen from the other counts, so that two bullets are no harder than one. Both move on straight
/// lines:
///
/// | pair          | when                                                                                        |
/// |---------------|---------------------------------------------------------------------------------------------|
/// | sphere, sphere| the centre meets a sphere of radius r1 + r2: a quadratic's first root, without cancellation  |
/// | sphere, plane | the height comes down to r: one division                                                    |
/// | sphere, box   | the distance is one quadratic between any two moments at which the centre passes a face     |
/// | box, plane    | as a sphere whose radius is the reach of the box along N                                     |
/// | box, box      | the last axis on which they come together                                                   |
///
/// A shape of yours that should be detected continuously needs its own `first_touch`, in the namespace of your shape
/// and in either order; without one it is tested where it is at the end of a step. Use `impact` without a World for two
/// bodies of your own.

#include <ansatz/collision/narrowphase/narrowphase.hpp>

#include <array>
#include <concepts>
#include <cstddef>
#include <limits>
#include <optional>

namespace ansatz {

/// When and where two bodies first touch.
template <class S> struct FirstTouch {
    typename S::Scalar time{};                       ///< the share of the motion that is done by then, from 0 to 1
    Vector<typename S::Scalar, S::dimension> normal; ///< N, from the second to the first
    typename S::Position arm{};                      ///< where they touch, seen from the first body's position then, m
};

namespace detail {
/// When the point q + t m, t from 0, first comes to within `reach` of the origin; 0 if it begins there and comes nearer
/// still. With l = |m| t: l = (|q|^2 - R^2) / (d + sqrt(R^2 - h^2)), h how near it would pass and d the way to there.
/// No difference of squares is formed, so that a touch far away is as exact as a near one.
template <class Raw, class Scalar>
bool point_meets_sphere(const Raw& q, const Raw& m, const Scalar& reach, Scalar& time) {
    using Metres = boost::units::quantity<unit::Length, Raw>;
    Raw along;
    if (!unit_vector(m, along)) return false;
    const Scalar way = -dot(q, along);
    if (!(way > Scalar(0))) return false;
    const Scalar distance = robust_norm(Metres::from_value(q)).value();
    if (!(distance > reach)) {
        time = Scalar(0);
        return true;
    }
    const Scalar nearest = robust_norm(Metres::from_value(Raw(q + way * along))).value();
    if (!(nearest < reach)) return false;
    const Scalar half_chord = sqrt(reach - nearest) * sqrt(reach + nearest);
    time = (distance - reach) * ((distance + reach) / (way + half_chord)) / robust_norm(Metres::from_value(m)).value();
    return time >= Scalar(0);
}

/// When the point q + t m is first in a box around the origin, and through which face: -1 if it begins inside.
template <class Raw, class Scalar>
bool point_meets_box(const Raw& q, const Raw& m, const Raw& half, Scalar& time, int& axis) {
    time = Scalar(0);
    axis = -1;
    Raw leaves = Raw::Constant(std::numeric_limits<Scalar>::max());
    for (int k = 0; k < int(Raw::RowsAtCompileTime); ++k) {
        const Scalar h = half[k];
        if (m[k] == Scalar(0)) {
            if (abs(q[k]) > h || (abs(q[k]) == h && h > Scalar(0))) return false; // beside it, or along a face
            continue;
        }
        const Scalar side = m[k] > Scalar(0) ? Scalar(-1) : Scalar(1); // of the face that it comes through
        const Scalar in = (side * h - q[k]) / m[k];
        leaves[k] = (-side * h - q[k]) / m[k];
        if (in > time || (in == time && axis < 0 && side * q[k] >= h)) time = in, axis = k;
    }
    // What only grazes an edge does not come in. On the axis of the face that it comes through it leaves later than it
    // comes, though from afar both may be rounded to one time: a thin wall is there all the same.
    for (int k = 0; k < int(Raw::RowsAtCompileTime); ++k)
        if (k == axis && half[k] > Scalar(0) ? leaves[k] < time : !(time < leaves[k])) return false;
    return true;
}

/// When the point q + t m, t from 0 to 1, first comes to within `reach` of a box around the origin.
template <class S>
bool point_nears_box(const Vector<typename S::Scalar, S::dimension>& q,
                     const Vector<typename S::Scalar, S::dimension>& m,
                     const Vector<typename S::Scalar, S::dimension>& half, const typename S::Scalar& reach,
                     typename S::Scalar& time, Vector<typename S::Scalar, S::dimension>& out) {
    using Scalar = typename S::Scalar;
    using Raw = Vector<Scalar, S::dimension>;
    std::array<Scalar, 2 * std::size_t(S::dimension) + 2> at;
    std::size_t n = 0;
    at[n++] = Scalar(0);
    for (int k = 0; k < S::dimension; ++k)
        for (const int side : {-1, 1}) {
            if (m[k] == Scalar(0)) continue;
            const Scalar t = (Scalar(side) * half[k] - q[k]) / m[k];
            if (!(t > Scalar(0) && t < Scalar(1))) continue;
            std::size_t place = n++; // in order
            for (; place > 0 && t < at[place - 1]; --place) at[place] = at[place - 1];
            at[place] = t;
        }
    at[n++] = Scalar(1);
    for (std::size_t i = 0; i + 1 < n; ++i) { // where it is outside of the same faces all the time
        const Scalar middle = at[i] / 2 + at[i + 1] / 2;
        Raw from, by;
        bool inside = true;
        for (int k = 0; k < S::dimension; ++k) {
            const Scalar x = q[k] + m[k] * middle;
            const bool beyond = abs(x) > half[k];
            inside = inside && !beyond;
            from[k] = beyond ? q[k] + m[k] * at[i] - (x < Scalar(0) ? -half[k] : half[k]) : Scalar(0);
            by[k] = beyond ? m[k] : Scalar(0);
        }
        Scalar later(0);
        if (!inside && (!point_meets_sphere(from, by, reach, later) || at[i] + later > at[i + 1])) continue;
        time = at[i] + later;
        out = from + later * by;
        return true;
    }
    return false;
}

/// The way a body has come down, of a reach and a height above a plane.
template <class S>
bool comes_down(const typename S::Scalar& above, const typename S::Scalar& by, typename S::Scalar& time) {
    using Scalar = typename S::Scalar;
    if (!(by < Scalar(0))) return false;
    time = above > Scalar(0) ? above / -by : Scalar(0);
    return time <= Scalar(1);
}
} // namespace detail

/// \name When two shapes are first so deep in each other
/// \param between x_a - x_b at the beginning, m
/// \param motion  by how much a moves, seen from b, m
/// \param deeper  how deep, m; zero for when they touch
/// \param first   what is found out; its `time` is 0 for bodies that are as deep already. Boxes need not ask whether
///                those come nearer: who calls looks at N
/// @{

/// Two spheres.
template <class S>
bool first_touch(const Sphere::In<S>& a, const Sphere::In<S>& b, const typename S::Position& between,
                 const typename S::Position& motion, const typename S::Length& deeper, FirstTouch<S>& first) {
    using Scalar = typename S::Scalar;
    const Scalar reach = max((a.radius + b.radius - deeper).value(), Scalar(0));
    if (!detail::point_meets_sphere(between.value(), motion.value(), reach, first.time) || first.time > Scalar(1))
        return false;
    if (!detail::unit_vector(Vector<Scalar, S::dimension>(between.value() + first.time * motion.value()), first.normal))
        first.normal = detail::no_direction<S>();
    first.arm = -a.radius * first.normal;
    return true;
}
/// A sphere and a plane.
template <class S>
bool first_touch(const Sphere::In<S>& a, const Plane::In<S>& b, const typename S::Position& between,
                 const typename S::Position& motion, const typename S::Length& deeper, FirstTouch<S>& first) {
    const auto above = b.height(between, S::template zero_vector<unit::Length>()) - a.radius + deeper;
    if (!detail::comes_down<S>(above.value(), dot(motion, b.normal).value(), first.time)) return false;
    first.normal = b.normal;
    first.arm = -a.radius * first.normal;
    return true;
}
/// A sphere and a box.
template <class S>
bool first_touch(const Sphere::In<S>& a, const Box::In<S>& b, const typename S::Position& between,
                 const typename S::Position& motion, const typename S::Length& deeper, FirstTouch<S>& first) {
    using Scalar = typename S::Scalar;
    const Scalar reach = max((a.radius - deeper).value(), a.radius.value() / 64);
    Vector<Scalar, S::dimension> out;
    if (!detail::point_nears_box<S>(between.value(), motion.value(), b.half.value(), reach, first.time, out))
        return false;
    if (!detail::unit_vector(out, first.normal)) { // its centre is inside
        const detail::NearestFace<S> face(S::Position::from_value(between.value() + first.time * motion.value()),
                                          b.half);
        for (int k = 0; k < S::dimension; ++k) first.normal[k] = k == face.axis ? face.out : Scalar(0);
    }
    first.arm = -a.radius * first.normal;
    return true;
}
/// A box and a plane.
template <class S>
bool first_touch(const Box::In<S>& a, const Plane::In<S>& b, const typename S::Position& between,
                 const typename S::Position& motion, const typename S::Length& deeper, FirstTouch<S>& first) {
    using Scalar = typename S::Scalar;
    Scalar reach(0);
    auto arm = a.half.value();
    for (int k = 0; k < S::dimension; ++k) {
        reach += abs(b.normal[k]) * arm[k];
        arm[k] *= b.normal[k] > Scalar(0) ? Scalar(-1) : b.normal[k] < Scalar(0) ? Scalar(1) : Scalar(0);
    }
    const auto above = b.height(between, S::template zero_vector<unit::Length>()) + deeper;
    if (!detail::comes_down<S>(above.value() - reach, dot(motion, b.normal).value(), first.time)) return false;
    first.normal = b.normal;
    first.arm = S::Position::from_value(arm);
    return true;
}
/// Two boxes.
template <class S>
bool first_touch(const Box::In<S>& a, const Box::In<S>& b, const typename S::Position& between,
                 const typename S::Position& motion, const typename S::Length& deeper, FirstTouch<S>& first) {
    using Scalar = typename S::Scalar;
    auto half = (a.half + b.half).value();
    for (int k = 0; k < S::dimension; ++k) half[k] = max(half[k] - deeper.value(), Scalar(0));
    int axis = -1;
    if (!detail::point_meets_box(between.value(), motion.value(), half, first.time, axis) || first.time > Scalar(1))
        return false;
    const typename S::Position then = between + first.time * motion;
    const int through = axis >= 0 ? axis : detail::NearestFace<S>(then, S::Position::from_value(half)).axis;
    auto arm = then.value();
    for (int k = 0; k < S::dimension; ++k) {
        const Scalar x = then.value()[k], ha = a.half.value()[k], hb = b.half.value()[k];
        const Scalar out = x < Scalar(0) ? Scalar(-1) : Scalar(1);
        first.normal[k] = k == through ? out : Scalar(0);
        arm[k] = k == through ? -out * ha : (max(-ha, -x - hb) + min(ha, -x + hb)) / 2; // the middle of what they share
    }
    first.arm = S::Position::from_value(arm);
    return true;
}
/// @}

namespace detail {
template <class A, class B, class S>
concept Sweeps = requires(const A& a, const B& b, const typename S::Position& x, const typename S::Length& depth,
                          FirstTouch<S>& first) {
    { first_touch(a, b, x, x, depth, first) } -> std::same_as<bool>;
};
/// Whether two shapes can be followed through a step.
template <class A, class B, class S> inline constexpr bool can_sweep = Sweeps<A, B, S> || Sweeps<B, A, S>;

/// When two shapes first touch, whichever order `first_touch` wants them in.
template <class S, class A, class B>
bool touch_first(const A& a, const B& b, const typename S::Position& between, const typename S::Position& motion,
                 const typename S::Length& deeper, FirstTouch<S>& first) {
    if constexpr (Sweeps<A, B, S>) return first_touch(a, b, between, motion, deeper, first);
    else {
        if (!first_touch(b, a, typename S::Position(-between), typename S::Position(-motion), deeper, first))
            return false;
        first.arm = first.arm - between - first.time * motion; // from b's place to a's
        first.normal = -first.normal;
        return true;
    }
}
} // namespace detail

/// When two bodies that move in a straight line first touch, if they do. Bodies that intersect from the beginning touch
/// at once, if they come nearer.
/// \param xa, xb where they begin, m
/// \param da, db by how much they move, m
/// \throws std::invalid_argument for a shape whose numbers are not acceptable
template <ShapeDescription A, ShapeDescription B, class X>
auto impact(const A& a, const X& xa, const X& da, const B& b, const X& xb, const X& db) {
    using S = typename detail::SpaceOfPosition<X>::type;
    constexpr bool known = detail::can_sweep<typename A::template In<S>, typename B::template In<S>, S>;
    static_assert(known, "Ansatz: impact: two shapes of which nothing knows when they first touch; write `template "
                         "<class S> bool first_touch(const A::In<S>&, const "
                         "B::In<S>&, const typename S::Position& between, const typename S::Position& motion, const "
                         "typename S::Length& deeper, FirstTouch<S>&)` "
                         "in the namespace of your shape");
    FirstTouch<S> first;
    bool there = false;
    if constexpr (known) {
        if constexpr (requires { a.check(); }) a.check();
        if constexpr (requires { b.check(); }) b.check();
        there = detail::touch_first<S>(typename A::template In<S>(a), typename B::template In<S>(b), X(xa - xb),
                                       X(da - db), S::Length::from_value(typename S::Scalar(0)), first) &&
                (first.time > typename S::Scalar(0) || dot(X(da - db), first.normal).value() < typename S::Scalar(0));
    }
    return there ? std::optional<FirstTouch<S>>(first) : std::nullopt;
}

} // namespace ansatz
