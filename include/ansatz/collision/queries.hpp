// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Ray` and `cast`: where a ray meets a shape, without a World. `World::query()` asks all bodies
/// (queries_in_world.hpp).
///
/// Use it for lines of sight, for shots that hit at once, for the height of the ground. A shape is solid: a ray
/// that begins inside hits at distance zero, with the normal against its direction. A ray that only grazes a surface
/// misses it.
///
/// A shape of yours needs `template <class S> bool ray_hits(const MyShape::In<S>&, const RayIn<S>&, const typename
/// S::Position& from, RayTouch<S>&)` in its namespace. Whether two shapes overlap is asked by `contact(a, xa, b, xb)`
/// of narrowphase.hpp.

#include <ansatz/collision/narrowphase/first_touch.hpp>

#include <limits>
#include <optional>
#include <string_view>

namespace ansatz {

/// From a point in a direction.
struct Ray {
    /// m, where it begins; finite
    VectorParameter<unit::Length> origin;
    /// without a unit, e.g. Eigen::Vector3d(0, -1, 0), of any length but zero; finite. In two dimensions the third
    /// component must be zero.
    VectorParameter<unit::Dimensionless> direction;
    /// m, how far it goes; not negative. Without it there is no end.
    Parameter<unit::Length> longest = std::numeric_limits<double>::max() * metre;

    /// \throws std::invalid_argument for an origin or a direction that is not finite, a direction of length zero, and a
    /// negative length
    void check() const {
        require_finite("Ray", "origin", origin);
        require_finite("Ray", "direction", direction);
        if (!(direction.value().cwiseAbs().maxCoeff() > 0))
            refuse_value("Ray", "direction", direction, "it has a length; along the first axis it is (1, 0, 0)");
        require_not_negative("Ray", "longest", longest);
    }
};

/// A ray in the scalar of a space.
template <class S> struct RayIn {
    typename S::Position origin;                        ///< m
    Vector<typename S::Scalar, S::dimension> direction; ///< a unit vector
    typename S::Length longest;                         ///< m
    /// \throws std::invalid_argument for a ray that is none, see Ray::check, or that the scalar cannot hold
    explicit RayIn(const Ray& ray) {
        ray.check();
        origin = S::convert("Ray::origin", VectorQuantity<unit::Length, 3>(ray.origin));
        direction = S::convert("Ray::direction",
                               VectorQuantity<unit::Dimensionless, 3>(ray.direction.value().stableNormalized()))
                        .value();
        const double most = double(std::numeric_limits<typename S::Scalar>::max());
        longest = S::Length::from_value(typename S::Scalar(ray.longest.value() < most ? ray.longest.value() : most));
    }
};

/// Where a ray meets a shape.
template <class S> struct RayTouch {
    typename S::Length distance{};                   ///< from its origin, m
    Vector<typename S::Scalar, S::dimension> normal; ///< of the surface, outwards
};

namespace detail {
/// It begins inside.
template <class S> bool hits_at_once(const RayIn<S>& ray, RayTouch<S>& touch) {
    touch.distance = S::Length::from_value(typename S::Scalar(0));
    touch.normal = -ray.direction;
    return true;
}
} // namespace detail

/// \name Where a ray meets a shape
/// \param from the ray's origin, seen from the shape's position, m
/// @{

/// A sphere.
template <class S>
bool ray_hits(const Sphere::In<S>& sphere, const RayIn<S>& ray, const typename S::Position& from, RayTouch<S>& touch) {
    using Scalar = typename S::Scalar;
    const auto along = dot(from, ray.direction).value(); // most are told from here
    const auto reach = sphere.radius.value();
    if (along > reach || -along - reach > ray.longest.value()) return false;
    const auto across =
        squared_norm(typename S::Position(from - along * S::Position::from_value(ray.direction))).value();
    if (detail::squares_well(across) && across > 4 * reach * reach) return false; // most of the others, without a root
    if (robust_norm(from) < sphere.radius) return detail::hits_at_once(ray, touch);
    Scalar time(0);
    if (!detail::point_meets_sphere(from.value(), ray.direction, reach, time) || time > ray.longest.value())
        return false;
    touch.distance = S::Length::from_value(time);
    // From so far that the scalar does not tell the surface from the centre, it is hit all the same.
    if (!detail::unit_vector(Vector<Scalar, S::dimension>(from.value() + time * ray.direction), touch.normal))
        touch.normal = -ray.direction;
    return true;
}
/// A plane.
template <class S>
bool ray_hits(const Plane::In<S>& plane, const RayIn<S>& ray, const typename S::Position& from, RayTouch<S>& touch) {
    const auto above = plane.height(from, S::template zero_vector<unit::Length>()).value();
    if (above < 0) return detail::hits_at_once(ray, touch);
    const auto down = -dot(ray.direction, plane.normal);
    if (!(down > 0) || above > down * ray.longest.value()) return false;
    touch.distance = S::Length::from_value(above / down);
    touch.normal = plane.normal;
    return touch.distance <= ray.longest;
}
/// A box.
template <class S>
bool ray_hits(const Box::In<S>& box, const RayIn<S>& ray, const typename S::Position& from, RayTouch<S>& touch) {
    typename S::Scalar time(0);
    int axis = -1;
    if (!detail::point_meets_box(from.value(), ray.direction, box.half.value(), time, axis) ||
        time > ray.longest.value())
        return false;
    if (axis < 0) return detail::hits_at_once(ray, touch);
    touch.distance = S::Length::from_value(time);
    for (int k = 0; k < S::dimension; ++k)
        touch.normal[k] = typename S::Scalar(k != axis ? 0 : ray.direction[k] > 0 ? -1 : 1);
    return true;
}
/// @}

namespace detail {
template <class A, class S>
concept MetByRays = requires(const typename A::template In<S>& shape, const RayIn<S>& ray,
                             const typename S::Position& x, RayTouch<S>& touch) {
    { ray_hits(shape, ray, x, touch) } -> std::same_as<bool>;
};
template <class A, class S> struct CheckRay {
    static_assert(MetByRays<A, S>,
                  "Ansatz: a ray is cast at a shape of which nothing knows where rays meet it; write `template <class "
                  "S> bool ray_hits(const A::In<S>&, "
                  "const RayIn<S>&, const typename S::Position& from, RayTouch<S>&)` in the namespace of your shape");
};
} // namespace detail

/// Where a ray meets a shape, if it does.
/// \param x where the shape is, m
/// \throws std::invalid_argument for a ray that is none, and a shape whose numbers are not acceptable
template <ShapeDescription A, class X> auto cast(const Ray& ray, const A& shape, const X& x) {
    using S = typename detail::SpaceOfPosition<X>::type;
    static_assert(sizeof(detail::CheckRay<A, S>) > 0);
    RayTouch<S> touch;
    bool there = false;
    if constexpr (detail::MetByRays<A, S>) {
        if constexpr (requires { shape.check(); }) shape.check();
        const RayIn<S> in(ray);
        there = ray_hits(typename A::template In<S>(shape), in, X(in.origin - x), touch);
    }
    return there ? std::optional<RayTouch<S>>(touch) : std::nullopt;
}

} // namespace ansatz
