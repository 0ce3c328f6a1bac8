// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What `World::add` takes: named properties of a body, in any order.
///
/// `world.add(position(metres(0, 10, 0)), mass(2.0 * kilogram))`: each property carries its name, so that a velocity is
/// never taken for a position, and each is checked for its unit at compile time and for its value at the door. A column
/// of your own is given with `with<Temperature>(293.0 * kelvin)`.

#include <ansatz/world/bodies.hpp> // before `fixed` and its like, or g++ takes the enumerators of Motion for their shadows
#include <ansatz/world/columns.hpp>

#include <concepts>
#include <type_traits>
#include <utility>

namespace ansatz {

/// A body that no physics touches (notes 1.1): infinite mass, no velocity, e.g. the ground.
struct Fixed {};
inline constexpr Fixed fixed{}; ///< no physics touches it: inverse mass zero, never integrated

/// A platform: infinite mass, moves with the velocity that it is given and is moved by nothing else.
struct Moving {};
inline constexpr Moving moving{}; ///< fixed, but with a velocity of its own: a platform

/// Added asleep: nothing is computed for it until something wakes it. Needs a world that can put bodies to rest. That
/// something holds it is yours to know: gravity alone wakes it only where forces are asked about the sleeping as well,
/// because they couple bodies or change with time.
struct Resting {};
inline constexpr Resting resting{}; ///< asleep from the beginning

/// A body that meets nothing: forces and effects act on it as on any other, but it has no shape to touch with, e.g. a
/// particle of cloth. Where bodies can meet one says so, because a forgotten shape goes unnoticed until
/// something falls through the ground. Where none do it is true of all and may be said as well, so that code for any
/// world can say it.
struct Shapeless {};
inline constexpr Shapeless shapeless{}; ///< meets nothing

/// A value for a column.
template <class C, class Q> struct Given {
    /// The column that it goes to.
    using column = C;
    Q value; ///< what was given
};

/// The mass of a body, a finite quantity greater than zero.
template <class Q> struct GivenMass {
    /// The column that it goes to.
    using column = InverseMass;
    Q value; ///< kg, as given
};

/// A datum of the user's own, for worlds with a `Datum<T>` policy.
template <class T> struct GivenDatum {
    /// What was given.
    T value;
};

namespace detail {
/// The module that a property of `add` belongs to, `void` for those of the frame: a type says so, `using module = ...`.
template <class T> struct ModuleOfProperty {
    using type = void;
};
template <class T>
    requires requires { typename T::module; }
struct ModuleOfProperty<T> {
    using type = typename T::module;
};

template <class T> inline constexpr bool is_given_mass = false;
template <class Q> inline constexpr bool is_given_mass<GivenMass<Q>> = true;

// One sentence for each property that is given something without a unit, or with another one.
template <class Unit, class Q> inline constexpr bool has_unit = false;
template <class Unit, class V> inline constexpr bool has_unit<Unit, boost::units::quantity<Unit, V>> = true;
template <class Q> inline constexpr bool vector_valued = false;
template <class U, class V> inline constexpr bool vector_valued<boost::units::quantity<U, V>> = is_matrix<V>;

template <class Q> struct Stripped {
    using type = Q;
};
template <class U, class V> boost::units::quantity<U, V> as_quantity(const boost::units::quantity<U, V>&);
template <class Q>
    requires requires(const Q& q) { as_quantity(q); }
struct Stripped<Q> {
    using type = decltype(as_quantity(std::declval<const Q&>()));
};
template <class Q> using stripped = typename Stripped<Q>::type;
} // namespace detail

/// Where the body is: a vector of length, e.g. `position(metres(0, 10, 0))`. The origin if it is not given.
template <class Q> auto position(const Q& x) {
    using Given_ = detail::stripped<Q>;
    // By name: clang prints the condition.
    constexpr bool fits = detail::has_unit<unit::Length, Given_> && detail::vector_valued<Given_>;
    static_assert(fits, "Ansatz: position takes a vector of lengths; write e.g. position(metres(0, 10, 0))");
    return Given<Position, Given_>{x};
}

/// Plain numbers.
template <class... Number>
    requires(sizeof...(Number) > 1)
auto position(const Number&...) {
    static_assert(detail::never<Number...>,
                  "Ansatz: position takes one vector of lengths; write e.g. position(metres(0, 10, 0))");
    return Given<Position, VectorQuantity<unit::Length, 3>>{};
}
/// Plain numbers.
template <class... Number>
    requires(sizeof...(Number) > 1)
auto velocity(const Number&...) {
    static_assert(detail::never<Number...>,
                  "Ansatz: velocity takes one vector of velocities; write e.g. velocity(metres_per_second(1, 0, 0))");
    return Given<Velocity, VectorQuantity<unit::Velocity, 3>>{};
}

/// How it moves: a vector of velocity, e.g. `velocity(metres_per_second(1, 0, 0))`. %Zero if it is not given.
template <class Q> auto velocity(const Q& v) {
    using Given_ = detail::stripped<Q>;
    // By name: clang prints the condition.
    constexpr bool fits = detail::has_unit<unit::Velocity, Given_> && detail::vector_valued<Given_>;
    static_assert(fits,
                  "Ansatz: velocity takes a vector of velocities; write e.g. velocity(metres_per_second(1, 0, 0))");
    return Given<Velocity, Given_>{v};
}

/// How heavy it is: e.g. `mass(2.0 * kilogram)`. Needed where the world stores mass.
template <class Q> auto mass(const Q& m) {
    using Given_ = detail::stripped<Q>;
    // By name: clang prints the condition.
    constexpr bool fits = detail::has_unit<unit::Mass, Given_> && !detail::vector_valued<Given_>;
    static_assert(fits, "Ansatz: mass takes a mass; write e.g. mass(2.0 * kilogram)");
    return GivenMass<Given_>{m};
}

/// A value for any column that a policy of the world stores, e.g. one of your own.
template <class C, class Q> auto with(const Q& value) {
    static_assert(Column<C>, "Ansatz: with<C> names a column: a type with Unit, shape and name; see columns.hpp");
    using Given_ = detail::stripped<Q>;
    if constexpr (!detail::own_shape<C>) // one of a shape of your own is checked where the scalar is known
        static_assert(detail::has_unit<typename C::Unit, Given_> &&
                          detail::vector_valued<Given_> == (C::shape == Shape::vector),
                      "Ansatz: the value given to with<C> has not the unit or the shape of column C");
    return Given<C, Given_>{value};
}

/// The user's own datum of the body.
template <class T> auto datum(T value) { return GivenDatum<T>{std::move(value)}; }

} // namespace ansatz
