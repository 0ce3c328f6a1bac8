// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Columns: what a world can store of each body, and the compile-time lists of them that policies declare.
///
/// A column is a tag: a unit, a shape (scalar or vector) and a name. A policy declares the columns that it reads and
/// writes; a world stores the union of these lists and nothing else, so that an effect that was not asked for has no
/// byte. Write a column of your own for a policy of your own (a temperature, a charge); the library need not know it.

#include <ansatz/units.hpp>

#include <concepts>
#include <cstddef>
#include <string_view>
#include <type_traits>

namespace ansatz {

/// One number of a body, or one number for each dimension. What else a column holds (a rotation, a symmetric matrix) is
/// a shape of your own: an object of a class, in the place of one of these.
///
/// \snippet tests/world/shapes.cpp shape
///
/// Its `Value<S, Unit>` says how it lies in lanes, by `from_lanes(raw)` and `to_lanes(raw)`, unless it is a quantity of
/// as many numbers as it has lanes; default constructed it is what a body has for which none is given. It may refuse
/// values from outside with `check() const`, which throws std::invalid_argument. In a hash and in a file it is its
/// lanes.
enum class Shape : unsigned char { scalar, vector };

namespace detail {
template <class C> using shape_of = std::remove_cvref_t<decltype(C::shape)>;
/// Whether a column holds something other than a number or a vector.
template <class C> inline constexpr bool own_shape = !std::convertible_to<shape_of<C>, Shape>;
/// Whether a class is a shape.
template <class T>
concept ShapeType = requires {
    { T::lanes(3) } -> std::convertible_to<std::size_t>;
};
} // namespace detail

/// \name The columns of the library
/// Position and Velocity are what integrators usually keep; InverseMass is 1/m, zero for a body that nothing moves.
/// @{

/// Where a body is.
struct Position {
    using Unit = unit::Length;
    static constexpr Shape shape = Shape::vector;
    static constexpr std::string_view name = "position";
};
/// How fast it moves.
struct Velocity {
    using Unit = unit::Velocity;
    static constexpr Shape shape = Shape::vector;
    static constexpr std::string_view name = "velocity";
};
/// 1/m; zero for what nothing can move.
struct InverseMass {
    using Unit = unit::InverseMass;
    static constexpr Shape shape = Shape::scalar;
    static constexpr std::string_view name = "inverse mass";
};
/// Where a body was one step ago, for an integrator that keeps history instead of velocity (notes 1.6.4).
struct PreviousPosition {
    using Unit = unit::Length;
    static constexpr Shape shape = Shape::vector;
    static constexpr std::string_view name = "previous position";
};
/// What rounding has dropped from Position: the two together are where a body is. Exists only with the integrator
/// Compensated. It may be given where a body is added, `with<PositionRemainder>(...)`.
struct PositionRemainder {
    using Unit = unit::Length;
    static constexpr Shape shape = Shape::vector;
    static constexpr std::string_view name = "position remainder";
};
/// The sum of the forces that couple bodies; exists only where some policy couples.
struct CoupledForce {
    using Unit = unit::Force;
    static constexpr Shape shape = Shape::vector;
    static constexpr std::string_view name = "coupled force";
};
/// What a solver of positions did to a body in the last substep, as an acceleration: a response that owns the
/// substeps expects it again in the next one. Exists only where both are.
struct HeldAcceleration {
    using Unit = unit::Acceleration;
    static constexpr Shape shape = Shape::vector;
    static constexpr std::string_view name = "held acceleration";
};
/// What the forces that act on one body alone do to it, m/s^2; not stored with the bodies, but kept for a substep
/// where something beside the integrator asks for it.
struct OwnAcceleration {
    using Unit = unit::Acceleration;
    static constexpr Shape shape = Shape::vector;
    static constexpr std::string_view name = "own acceleration";
};
/// What a user's own forces add up to until the next step is done; exists only with the policy AppliedForces.
struct AppliedForce {
    using Unit = unit::Force;
    static constexpr Shape shape = Shape::vector;
    static constexpr std::string_view name = "applied force";
    static constexpr bool transient = true; ///< the step sets it back to zero when it has used it
};
/// How long a body has been slow; counted only in worlds that put bodies to rest.
struct RestTime {
    using Unit = unit::Time;
    static constexpr Shape shape = Shape::scalar;
    static constexpr std::string_view name = "rest time";
};
/// Where a body was drawn last; exists only with the policy Interpolation.
struct DrawnPosition {
    using Unit = unit::Length;
    static constexpr Shape shape = Shape::vector;
    static constexpr std::string_view name = "drawn position";
};
/// Scratch that a stage leaves for a later one: a local while nothing couples, a column otherwise.
template <class UnitT, int Number = 0> struct ScratchVector {
    using Unit = UnitT;
    static constexpr Shape shape = Shape::vector;
    static constexpr std::string_view name = "scratch";
};
/// Not stored: a law that lists Clock among what it reads may ask its context for the time. Because the world knows
/// which laws do, it also knows that it must check resting bodies again while time passes.
struct Clock {};
/// @}

/// A column: its unit, shape and name. It may also name the bounds of its numbers (column_range.hpp), and the policies
/// that ask for it: `template <bool Stored> struct Needs` with an assertion, for worlds without one (`Restitution` has
/// it).
template <class C>
concept Column = requires {
    typename C::Unit;
    requires std::convertible_to<detail::shape_of<C>, Shape> || detail::ShapeType<detail::shape_of<C>>;
    { C::name } -> std::convertible_to<std::string_view>;
};

/// A compile-time list of columns.
template <class... C> struct Columns {
    /// How many there are.
    static constexpr std::size_t size = sizeof...(C);
};

namespace detail {

template <class T> inline constexpr bool is_columns = false;
template <class... C> inline constexpr bool is_columns<Columns<C...>> = ((Column<C> || std::same_as<C, Clock>)&&...);

/// Where a type stands in a list of types.
template <class T, class List> inline constexpr std::size_t place_of = 0;
template <class T, template <class...> class List, class First, class... Rest>
inline constexpr std::size_t place_of<T, List<First, Rest...>> =
    std::same_as<T, First> ? 0 : 1 + place_of<T, List<Rest...>>;

template <class C, class List> inline constexpr bool contains = false;
template <class C, class... In> inline constexpr bool contains<C, Columns<In...>> = (std::same_as<C, In> || ...);

// The union keeps the order of first mention, so that the layout of a world follows its list of policies.
template <class Done, class... Lists> struct Union {
    using type = Done;
};
template <class... Done, class Next, class... More, class... Lists>
struct Union<Columns<Done...>, Columns<Next, More...>, Lists...> {
    using grown = std::conditional_t<contains<Next, Columns<Done...>> || std::same_as<Next, Clock>, Columns<Done...>,
                                     Columns<Done..., Next>>;
    using type = typename Union<grown, Columns<More...>, Lists...>::type;
};
template <class... Done, class... Lists> struct Union<Columns<Done...>, Columns<>, Lists...> {
    using type = typename Union<Columns<Done...>, Lists...>::type;
};

template <class List, class Minus> struct Difference;
template <class... C, class Minus> struct Difference<Columns<C...>, Minus> {
    using type = typename Union<Columns<>, std::conditional_t<contains<C, Minus>, Columns<>, Columns<C>>...>::type;
};

template <class List, class With> struct Intersection;
template <class... C, class With> struct Intersection<Columns<C...>, With> {
    using type = typename Union<Columns<>, std::conditional_t<contains<C, With>, Columns<C>, Columns<>>...>::type;
};

template <class P> struct Reads {
    using type = Columns<>;
};
template <class P>
    requires requires { typename P::reads; }
struct Reads<P> {
    using type = typename P::reads;
};
template <class P> struct Writes {
    using type = Columns<>;
};
template <class P>
    requires requires { typename P::writes; }
struct Writes<P> {
    using type = typename P::writes;
};

} // namespace detail

/// The union of column lists, in the order of first mention, without `Clock`.
template <class... Lists> using union_of = typename detail::Union<Columns<>, Lists...>::type;
/// The columns of `List` that are not in `Minus`.
template <class List, class Minus> using difference_of = typename detail::Difference<List, Minus>::type;
/// The columns of `List` that are in `With`.
template <class List, class With> using intersection_of = typename detail::Intersection<List, With>::type;
/// What a policy declares that it reads or writes; empty where it declares nothing.
template <class P> using reads_of = typename detail::Reads<P>::type;
/// The columns that a policy changes; none where it names none.
template <class P> using writes_of = typename detail::Writes<P>::type;

namespace detail {
template <class C, class S, bool Own = own_shape<C>> struct ValueOf {
    using type = std::conditional_t<C::shape == Shape::vector, typename S::template VectorOf<typename C::Unit>,
                                    typename S::template ScalarOf<typename C::Unit>>;
};
template <class C, class S> struct ValueOf<C, S, true> {
    using type = typename shape_of<C>::template Value<S, typename C::Unit>;
};
} // namespace detail

/// A column's value in a space: a scalar or a vector quantity, or what a shape of your own makes of them.
template <class C, class S> using value_of = typename detail::ValueOf<C, S>::type;

/// How many lanes (arrays of raw scalars) a column takes in a space of `Dim` dimensions.
template <class C> constexpr std::size_t lanes_of(int dimension) {
    if constexpr (detail::own_shape<C>) return detail::shape_of<C>::lanes(dimension);
    else return C::shape == Shape::vector ? std::size_t(dimension) : 1;
}

namespace detail {
/// Whether the values of a column say themselves how they lie in lanes; those of another are quantities.
template <class C, class S>
inline constexpr bool has_own_lanes =
    own_shape<C> && requires(const typename S::Scalar* raw) { value_of<C, S>::from_lanes(raw); };
/// Room for one value of a column, as raw scalars.
template <class C, class S>
inline constexpr std::size_t room_for = lanes_of<C>(S::dimension) < 3 ? 3 : lanes_of<C>(S::dimension);
} // namespace detail

} // namespace ansatz
