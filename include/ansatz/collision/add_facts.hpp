// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What can be wrong with the shape that `World::add` is given for a body, each with its sentence.
// not in the umbrella: it is a part of collision/module.hpp, which includes it

#include <ansatz/collision/properties.hpp>
#include <ansatz/world/add_facts.hpp>

#include <concepts>
#include <type_traits>

namespace ansatz::detail {

template <class C> inline constexpr bool collides_in = requires { requires C::collides; };

/// The shape among the properties.
inline Absent given_shape() { return {}; }
template <class First, class... Rest>
auto given_shape([[maybe_unused]] const First& first, [[maybe_unused]] const Rest&... rest) {
    if constexpr (ShapeDescription<First>) return first;
    else return given_shape(rest...);
}
/// The same in the scalar of the space; refused where its numbers are not acceptable.
template <class S, class T> auto shape_in([[maybe_unused]] const T& description) {
    if constexpr (ShapeDescription<T>) {
        check_in<S>(description);
        return typename T::template In<S>(description);
    } else return Absent{};
}

template <class C, class... Property> struct ShapeAddFacts {
    using World_ = AddFacts<C, void, Property...>;
    static constexpr bool properties = World_::properties;
    static constexpr bool shape_once = (0 + ... + int(ShapeDescription<Property>)) <= 1;
    static constexpr bool shape_wanted =
        collides_in<C> || !((ShapeDescription<Property> || std::same_as<Property, Sensor>) || ...);
    template <class T> static constexpr bool is_known() {
        if constexpr (ShapeDescription<T> && collides_in<C>) return C::Narrowphase::template knows<T>;
        return true;
    }
    static constexpr bool shape_known = (is_known<Property>() && ...);
    static constexpr bool has_shape = (ShapeDescription<Property> || ...);
    static constexpr bool is_sensor = (std::same_as<Property, Sensor> || ...);
    static constexpr bool is_shapeless = (std::same_as<Property, Shapeless> || ...);
    static constexpr bool sensor_has_shape = !is_sensor || has_shape;
    static constexpr bool shape_or_none = !has_shape || !is_shapeless;
    static constexpr bool shape_there = !collides_in<C> || has_shape || is_shapeless || is_sensor;
    static constexpr bool ok =
        shape_once && shape_wanted && shape_known && sensor_has_shape && shape_or_none && shape_there;
};
template <class C, class... Property> struct CheckShapeAdd : ShapeAddFacts<C, Property...> {
    using Facts = ShapeAddFacts<C, Property...>;
    using Facts::shape_once, Facts::shape_wanted, Facts::shape_known, Facts::sensor_has_shape, Facts::shape_or_none,
        Facts::shape_there, Facts::properties;
    static_assert(shape_once, "Ansatz: add: a body has one shape; add several bodies for several shapes");
    static_assert(
        shape_wanted,
        "Ansatz: add: bodies of this world do not collide, so it takes no shape; add a broadphase, a narrowphase and a "
        "response to its policies, e.g. SortAndSweep{}, Narrowphase<Sphere, Plane>{}, Impulse{}");
    static_assert(shape_known, "Ansatz: add: a shape that this world's narrowphase does not know; name it "
                               "there, e.g. Narrowphase<Sphere, Plane, Box>{}");
    static_assert(sensor_has_shape || !shape_wanted,
                  "Ansatz: add: a sensor without a shape notices nobody; give it one, e.g. add(Sphere{2.0 * metre}, "
                  "sensor, fixed)");
    static_assert(shape_or_none, "Ansatz: add: a body has a shape or is shapeless, not both; leave one out");
    static_assert(
        shape_there || !properties,
        "Ansatz: add: bodies of this world collide, and this one would meet nothing; give it a shape that the "
        "narrowphase knows, e.g. add(Sphere{0.5 * metre}, ...), or say so: add(shapeless, ...)");
};

} // namespace ansatz::detail
