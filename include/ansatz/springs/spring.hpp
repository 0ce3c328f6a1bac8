// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Spring` and `Rope`: what one spring of a world is, as it is given to `World::add` and read back.
///
/// `world.add(Spring{ball, hook, 100.0 * newton_per_metre})`: its ends are bodies, or one of them is a point of the
/// world that nothing moves. Without a rest length it is at rest as it is added. A Rope is a spring that only pulls.
/// Where it breaks is given beside it, `world.add(Rope{...}, breaks_at(50.0 * newton))`, in a world whose springs can
/// (`Springs<Breaking>`, `Ropes<Breaking>`).

#include <ansatz/springs/hooke.hpp>
#include <ansatz/world/elements.hpp>
#include <ansatz/world/properties.hpp>

#include <concepts>
#include <limits>
#include <optional>

namespace ansatz {

/// One end of a spring: a body, or a point of the world.
class SpringEnd {
public:
    /// No end yet; a spring with it is refused.
    SpringEnd() = default;
    /// A body.
    // NOLINTNEXTLINE(google-explicit-constructor): an end is a body or a point
    SpringEnd(Handle body) : body_(body), is_body_(true) {}
    /// A point that nothing moves, in m.
    template <class Q>
        requires(detail::has_unit<unit::Length, detail::stripped<Q>> && detail::vector_valued<detail::stripped<Q>>)
    // NOLINTNEXTLINE(google-explicit-constructor)
    SpringEnd(const Q& point) : point_(detail::stripped<Q>(point)), is_point_(true) {}
    /// Another quantity: a mistake.
    template <class Unit, class Value>
        requires(!(std::same_as<Unit, unit::Length> &&
                   detail::vector_valued<detail::stripped<boost::units::quantity<Unit, Value>>>))
    // NOLINTNEXTLINE(google-explicit-constructor)
    SpringEnd(const boost::units::quantity<Unit, Value>&) {
        constexpr bool is_place = sizeof(Value) == 0;
        static_assert(is_place,
                      "Ansatz: an end of a spring is the handle of a body, or a point; write e.g. metres(0, 2, 0)");
    }

    bool is_body() const { return is_body_; }   ///< whether it is a body
    bool is_point() const { return is_point_; } ///< whether it is a point
    Handle body() const { return body_; }       ///< the body; an empty handle where it is a point
    const VectorParameter<unit::Length>& point() const { return point_; } ///< m; the origin where it is a body

private:
    Handle body_{};
    VectorParameter<unit::Length> point_{};
    bool is_body_ = false, is_point_ = false;
};

/// A spring: pulls when it is longer than its rest length and pushes when it is shorter (notes 3).
struct Spring {
    using element = Spring; ///< World::add takes it

    SpringEnd first = {};                                          ///< a body, or a point
    SpringEnd second = {};                                         ///< a body, or a point; one of them is a body
    Parameter<unit::Stiffness> stiffness = 0.0 * newton_per_metre; ///< k, N/m, finite, not negative; 0 is a mere damper
    Parameter<unit::Damping> damping = 0.0 * newton_second_per_metre; ///< c along the axis, N s/m, finite, not negative
    /// m, finite, not negative; without it the distance when it is added
    std::optional<Parameter<unit::Length>> rest_length = {};
};

/// A rope: pulls when it is longer than its rest length, and never pushes.
struct Rope {
    using element = Rope; ///< World::add takes it

    SpringEnd first = {};                                             ///< a body, or a point
    SpringEnd second = {};                                            ///< a body, or a point; one of them is a body
    Parameter<unit::Stiffness> stiffness = 0.0 * newton_per_metre;    ///< k, N/m, finite, not negative
    Parameter<unit::Damping> damping = 0.0 * newton_second_per_metre; ///< c along the axis, N s/m, finite, not negative
    /// m, finite, not negative; without it the distance when it is added
    std::optional<Parameter<unit::Length>> rest_length = {};
};

/// Names a spring.
using SpringHandle = ElementHandle<Spring>;
/// Names a rope.
using RopeHandle = ElementHandle<Rope>;

/// Where a spring breaks; infinite where it does not.
struct BreakLimit {
    Parameter<unit::Force> force = std::numeric_limits<double>::infinity() * newton; ///< N, of the tension or the push
    double strain = std::numeric_limits<double>::infinity(); ///< |length - rest length| / rest length
};

/// A spring breaks when it pulls or pushes with more than this.
/// \param force N, greater than zero
template <class Unit, class Value> BreakLimit breaks_at(const boost::units::quantity<Unit, Value>& force) {
    constexpr bool is_force = std::same_as<Unit, unit::Force> && std::is_arithmetic_v<Value>;
    static_assert(is_force, "Ansatz: breaks_at takes a force, or a strain as a number; write e.g. breaks_at(50.0 * "
                            "newton) or breaks_at(0.3)");
    if constexpr (is_force) return {.force = force};
    return {};
}
/// A spring breaks when its length differs from its rest length by more than this fraction of the rest length.
/// \param strain greater than zero; 0.3 is thirty per cent
template <std::convertible_to<double> Number>
    requires std::is_arithmetic_v<Number>
BreakLimit breaks_at(Number strain) {
    return {.strain = double(strain)};
}

/// A spring that broke in the last step.
/// \tparam Element Spring or Rope
template <class Element> struct Broken {
    ElementHandle<Element> which;  ///< its handle, stale by now
    SpringEnd first;               ///< what it held: a body
    SpringEnd second;              ///< and another, or a point
    Quantity<unit::Force> tension; ///< N, with which it pulled; negative where it pushed
    double strain;                 ///< (length - rest length) / rest length; 0 where the rest length is 0
};

} // namespace ansatz
