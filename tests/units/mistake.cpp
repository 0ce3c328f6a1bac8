// SPDX-License-Identifier: BSL-1.0
// Expressions that must not exist, asked politely. Their sentences are in tests/must_not_compile.

#include <ansatz/units/mistake.hpp>

#include "tests/catch.hpp"

#include "tests/units/spaces.hpp"

using namespace ansatz;
using namespace ansatz::test;

namespace {

template <class A, class B>
concept Adds = requires(A a, B b) { a + b; };
template <class A, class B>
concept Subtracts = requires(A a, B b) { a - b; };
template <class A, class B>
concept Multiplies = requires(A a, B b) { a* b; };
template <class A, class B>
concept Divides = requires(A a, B b) { a / b; };
template <class A, class B>
concept AddsInPlace = requires(A a, B b) { a += b; };
template <class A, class B>
concept SubtractsInPlace = requires(A a, B b) { a -= b; };
template <class A, class B>
concept Equals = requires(A a, B b) { a == b; };
template <class A, class B>
concept IsLess = requires(A a, B b) { a < b; };
template <class A, class B>
concept Dots = requires(A a, B b) { dot(a, b); };

template <class A, class B> constexpr bool sums = Adds<A, B> || Subtracts<A, B> || Adds<B, A> || Subtracts<B, A>;
template <class A, class B> constexpr bool compares = Equals<A, B> || IsLess<A, B> || Equals<B, A> || IsLess<B, A>;

template <class S, int D> constexpr bool nothing_wrong_exists() {
    using Length = Quantity<unit::Length, S>;
    using Time = Quantity<unit::Time, S>;
    using Position = VectorQuantity<unit::Length, D, S>;
    using Velocity = VectorQuantity<unit::Velocity, D, S>;
    using Jacobian = MatrixQuantity<unit::Frequency, D, S>;
    using Plain = Vector<S, D>;
    using Other = VectorQuantity<unit::Length, 5 - D, S>;
    // The checks can say yes.
    static_assert(sums<Length, Length> && sums<Position, Position> && compares<Length, Length> &&
                  Equals<Position, Position>);
    static_assert(Multiplies<Length, Position> && Multiplies<Plain, Length> && AddsInPlace<Position&, Position> &&
                  AddsInPlace<Length&, Length>);
    static_assert(Dots<Position, Velocity> && Divides<Position, Length> && Multiplies<Jacobian, Position>);
    // Different units.
    static_assert(!sums<Length, Time> && !sums<Position, Velocity> && !sums<Length, Quantity<unit::Area, S>>);
    static_assert(!sums<Jacobian, MatrixQuantity<unit::Stiffness, D, S>> &&
                  !sums<Length, Quantity<unit::Dimensionless, S>>);
    static_assert(!compares<Length, Time> && !Equals<Position, Velocity>);
    static_assert(!AddsInPlace<Position&, Velocity> && !SubtractsInPlace<Position&, Velocity>);
    // Different shapes.
    static_assert(!sums<Length, Position> && !sums<Position, Other> &&
                  !sums<Position, MatrixQuantity<unit::Length, D, S>>);
    static_assert(!AddsInPlace<Position&, Length> && !AddsInPlace<Position&, Other> && !Dots<Position, Other>);
    static_assert(!Multiplies<Jacobian, Other> && !Multiplies<Position, Jacobian>);
    // Bare numbers.
    static_assert(!sums<Length, double> && !sums<Length, int> && !sums<Length, S> && !sums<Position, double> &&
                  !sums<Position, Plain>);
    static_assert(!compares<Length, double> && !compares<Length, int> && !compares<Length, float>);
    static_assert(!AddsInPlace<Length&, double> && !AddsInPlace<Position&, double> && !AddsInPlace<Position&, Plain>);
    // Vector times vector, and division by a vector.
    static_assert(!Multiplies<Position, Velocity> && !Multiplies<Position, Position> && !Multiplies<Position, Other>);
    static_assert(!Multiplies<Position, Plain> && !Multiplies<Plain, Position>);
    static_assert(!Divides<Position, Velocity> && !Divides<Length, Position> && !Divides<double, Position>);
    static_assert(!Divides<Plain, Position> && !Divides<Position, Plain> && !Divides<unit::Length, Position>);
    return true;
}
static_assert(nothing_wrong_exists<float, 2>() && nothing_wrong_exists<float, 3>());
static_assert(nothing_wrong_exists<double, 2>() && nothing_wrong_exists<double, 3>());
static_assert(nothing_wrong_exists<Precise, 2>() && nothing_wrong_exists<Precise, 3>());

// Precisions that meet in place: Boost would round a double into a float without a word.
static_assert(!AddsInPlace<Quantity<unit::Length, float>&, Quantity<unit::Length>>);
static_assert(!AddsInPlace<Quantity<unit::Length>&, Quantity<unit::Length, float>>);
static_assert(!SubtractsInPlace<Quantity<unit::Length, float>&, Quantity<unit::Length>>);
static_assert(!AddsInPlace<VectorQuantity<unit::Length, 3, float>&, VectorQuantity<unit::Length>>);
static_assert(!Dots<VectorQuantity<unit::Length, 3, float>, VectorQuantity<unit::Length>>);
// A number without a unit belongs to dimensionless quantities.
static_assert(sums<Quantity<unit::Dimensionless>, double> && compares<Quantity<unit::Dimensionless>, double>);
// Parameters are no loophole.
static_assert(!sums<Parameter<unit::Length>, Quantity<unit::Time>> && !sums<Parameter<unit::Length>, double>);
static_assert(!sums<Parameter<unit::Length>, Parameter<unit::Time>> && !compares<Parameter<unit::Length>, double>);
static_assert(!Multiplies<VectorParameter<unit::Length>, VectorParameter<unit::Length>>);

} // namespace

TEST_CASE("expressions that must not exist do not", "[units]") {
    SUCCEED("checked by the compiler: this file would not build");
}
