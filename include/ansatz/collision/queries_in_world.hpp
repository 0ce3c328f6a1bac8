// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Query`: what `World::query()` answers: ray casts and overlaps, of all bodies as they are now.
///
/// A plain loop over the bodies. The broadphases of this library find all pairs at once and are made anew in each
/// step, because everything moves; to make one for a single ray costs about as much as a test of every body, or a
/// multiple. Measured with 1000, 10 000 and 100 000 spheres (g++ 12, -O2, two cores with other work): a ray 155, 153
/// and 125 ns a body, the overlap of a sphere 103, 94 and 94 ns, and the fastest broadphase on the same boxes 88, 681
/// and 661 ns a body. For thousands of rays a step in a scene of many bodies that stand still, keep a tree of your own.
///
/// Behind the ray or the shape stand options in any order: `with_sensors`, and what the world's filter reads, as
/// if the ray were a body: `ignores(1 << 3)`, `member_of(2)` for `Layers`. Nothing is allocated: lists go into a vector
/// of yours.

#include <ansatz/collision/queries.hpp>
#include <ansatz/world/world.hpp>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <tuple>
#include <vector>

namespace ansatz {

namespace detail {
template <class List> struct ReadByAll;
template <class... F> struct ReadByAll<Types<F...>> {
    using type = union_of<Columns<>, reads_of<F>...>;
};
} // namespace detail

/// Sensors are told, too.
struct WithSensors {};
inline constexpr WithSensors with_sensors{}; ///< an option of queries

/// A body that a ray meets.
template <class S> struct RayHit : RayTouch<S> {
    Handle body;                  ///< the body that was hit
    typename S::Position point{}; ///< where, m
};

/// Asks the bodies of a world. It refers to the world: do not keep it.
/// \tparam C the world's composition
template <class C, class Policies> class Query {
public:
    using S = typename C::S;            ///< the space
    using Hit = RayHit<S>;              ///< a body that a ray meets
    using Point = typename S::Position; ///< m

    /// Of a world.
    Query(const WorldData<C>& data, const Policies& policies) : data_(data), policies_(policies) {}

    /// The body that a ray meets first; of two as near, the one with the smaller id.
    /// \throws std::invalid_argument for a ray that is none, see Ray
    template <class... Option> std::optional<Hit> closest(const Ray& ray, const Option&... option) const {
        std::optional<Hit> best;
        RayIn<S> in(ray);
        each_hit(
            in,
            [&](const Hit& hit) {
                if (best && !earlier(hit, *best)) return;
                best = hit;
                in.longest = hit.distance; // what is behind it does not count
            },
            option...);
        return best;
    }
    /// All bodies that a ray meets, by their distances, then their ids.
    /// \param hits in place of what was in it
    /// \throws std::invalid_argument for a ray that is none, see Ray
    template <class... Option> void all(const Ray& ray, std::vector<Hit>& hits, const Option&... option) const {
        const RayIn<S> in(ray);
        hits.clear();
        each_hit(
            in, [&](const Hit& hit) { hits.push_back(hit); }, option...);
        std::sort(hits.begin(), hits.end(), earlier);
    }
    /// The bodies that a shape overlaps, by their ids; one that only touches it is none of them. For any shape that the
    /// world's shapes collide with, e.g. a Sphere or a Box.
    /// \param x      where the shape is, m
    /// \param bodies in place of what was in it
    /// \throws std::invalid_argument for a shape whose numbers are not acceptable, and a place that is not finite
    template <ShapeDescription Kind, class X, class... Option>
    void overlap(const Kind& shape, const X& x, std::vector<Handle>& bodies, const Option&... option) const {
        if constexpr (requires { shape.check(); }) shape.check();
        const typename Kind::template In<S> in(shape);
        const Point at = detail::finite_vector<S, unit::Length>("World::query().overlap", "the shape's position", x);
        bodies.clear();
        Touch<S> touch;
        each(
            [&](const auto& other, std::size_t slot) {
                using Other = typename std::remove_cvref_t<decltype(other)>::description;
                static_assert(sizeof(detail::CheckPair<Kind, Other, S>) > 0);
                if (detail::intersect<S>(in, at, other, data_.lanes.template get<Position>(slot), touch))
                    bodies.push_back(data_.bodies.handle(slot));
            },
            option...);
        std::sort(bodies.begin(), bodies.end(), [](const Handle& a, const Handle& b) { return a.id < b.id; });
    }

private:
    static bool earlier(const Hit& a, const Hit& b) {
        return a.distance != b.distance ? a.distance < b.distance : a.body.id < b.body.id;
    }

    template <class F, class... Option> void each_hit(const RayIn<S>& ray, F&& f, const Option&... option) const {
        each(
            [&](const auto& shape, std::size_t slot) {
                using Kind = typename std::remove_cvref_t<decltype(shape)>::description;
                static_assert(sizeof(detail::CheckRay<Kind, S>) > 0);
                if constexpr (detail::MetByRays<Kind, S>) {
                    Hit hit;
                    if (!ray_hits(shape, ray, Point(ray.origin - data_.lanes.template get<Position>(slot)), hit))
                        return;
                    hit.body = data_.bodies.handle(slot);
                    hit.point = ray.origin + hit.distance.value() * Point::from_value(ray.direction);
                    f(hit);
                }
            },
            option...);
    }

    using filter_columns = typename detail::ReadByAll<typename C::filters>::type;
    template <class Option> static constexpr bool is_sensors = std::same_as<Option, WithSensors>;
    template <class Option>
    static constexpr bool is_known = [] {
        if constexpr (is_sensors<Option>) return true;
        else if constexpr (requires { typename Option::column; })
            return detail::contains<typename Option::column, filter_columns>;
        else return false;
    }();

    /// Calls `f(shape, slot)` for each body that the options let through.
    template <class F, class... Option> void each(F&& f, const Option&... option) const {
        constexpr bool known = (is_known<Option> && ...);
        static_assert(known, "Ansatz: query: an option that means nothing here; it is with_sensors, or something that "
                             "the world's filter reads, e.g. ignores(1 << 3) "
                             "in a world with Layers{}");
        if constexpr (known) {
            Row<S, filter_columns> asking{};
            [[maybe_unused]] auto take = [&](const auto& given) {
                if constexpr (requires { given.value; }) {
                    using Column = typename std::remove_cvref_t<decltype(given)>::column;
                    asking.template get<Column>() =
                        detail::finite_scalar<S, typename Column::Unit>("World::query()", Column::name, given.value);
                }
            };
            (take(option), ...);
            constexpr bool sensors = (is_sensors<Option> || ...);
            for (std::size_t slot = 0; slot < data_.bodies.size(); ++slot) {
                const auto id = data_.bodies.id(slot);
                if (!sensors && data_.collisions.is_sensor(id)) continue;
                if (!passes(asking, slot, typename C::filters{})) continue;
                data_.collisions.shapes.visit(id, [&](const auto& shape) { f(shape, slot); });
            }
        }
    }
    static bool passes(const auto&, std::size_t, Types<>) { return true; }
    template <class Filter> bool passes(const auto& asking, std::size_t slot, Types<Filter>) const {
        if constexpr (detail::sees_of<Filter>::size > 0) return true; // a query is no body, and in no table
        else
            return typename Filter::template In<S>(std::get<Filter>(policies_))
                .passes(asking, data_.lanes.get(filter_columns{}, slot));
    }

    const WorldData<C>& data_;
    const Policies& policies_;
};

} // namespace ansatz
