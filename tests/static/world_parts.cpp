// SPDX-License-Identifier: BSL-1.0
// The compile-time parts of a world: columns and their lists, roles, properties, and what is a world at all.

#include <ansatz/collision.hpp>
#include <ansatz/collision/add_facts.hpp>
#include <ansatz/collision/door.hpp>
#include <ansatz/collision/facts.hpp>
#include <ansatz/collision/module.hpp>
#include <ansatz/collision/properties.hpp>
#include <ansatz/collision/roles.hpp>
#include <ansatz/collision/sleep.hpp>
#include <ansatz/collision/step.hpp>
#include <ansatz/motion/check.hpp>
#include <ansatz/motion/concepts.hpp>
#include <ansatz/motion/door.hpp>
#include <ansatz/motion/facts.hpp>
#include <ansatz/motion/module.hpp>
#include <ansatz/motion/rest_step.hpp>
#include <ansatz/motion/roles.hpp>
#include <ansatz/motion/state.hpp>
#include <ansatz/motion/step.hpp>
#include <ansatz/world.hpp>
#include <ansatz/world/check.hpp>
#include <ansatz/world/columns.hpp>
#include <ansatz/world/concepts.hpp>
#include <ansatz/world/declaration.hpp>
#include <ansatz/world/properties.hpp>
#include <ansatz/world/roles.hpp>
#include <ansatz/world/row.hpp>

#include <concepts>

using namespace ansatz;

namespace {

// ---------------------------------------------------------------- columns
struct NoName {
    using Unit = unit::Length;
    [[maybe_unused]] static constexpr Shape shape = Shape::scalar;
};
struct NoShape {
    using Unit = unit::Length;
    [[maybe_unused]] static constexpr std::string_view name = "no shape";
};
struct NoUnit {
    [[maybe_unused]] static constexpr Shape shape = Shape::scalar;
    [[maybe_unused]] static constexpr std::string_view name = "no unit";
};
static_assert(Column<Position> && Column<Velocity> && Column<ScratchVector<unit::Length, 1>>);
static_assert(!Column<NoName> && !Column<NoShape> && !Column<NoUnit> && !Column<Clock> && !Column<int>);

static_assert(std::same_as<union_of<>, Columns<>>);
static_assert(std::same_as<union_of<Columns<Velocity>, Columns<Position, Velocity>>,
                           Columns<Velocity, Position>>); // first mention first
static_assert(std::same_as<union_of<Columns<Clock, Position>, Columns<>, Columns<Clock>>,
                           Columns<Position>>); // a clock is not stored
static_assert(std::same_as<union_of<Columns<Position, Position>>, Columns<Position>>);
static_assert(
    std::same_as<difference_of<Columns<Position, Velocity, RestTime>, Columns<Velocity>>, Columns<Position, RestTime>>);
static_assert(std::same_as<difference_of<Columns<Position>, Columns<Position>>, Columns<>>);
static_assert(
    std::same_as<intersection_of<Columns<Position, Velocity>, Columns<Velocity, InverseMass>>, Columns<Velocity>>);
static_assert(std::same_as<intersection_of<Columns<Position>, Columns<>>, Columns<>>);
static_assert(std::same_as<reads_of<Gravity>, Columns<>> && std::same_as<writes_of<Gravity>, Columns<>> &&
              std::same_as<reads_of<int>, Columns<>>);
static_assert(std::same_as<writes_of<Drag>, Columns<Velocity>> &&
              std::same_as<reads_of<QuadraticDrag>, Columns<Velocity>>);

static_assert(std::same_as<value_of<Position, Space<float, 2>>, VectorQuantity<unit::Length, 2, float>>);
static_assert(std::same_as<value_of<InverseMass, Space<>>, Quantity<unit::InverseMass>>);
static_assert(lanes_of<Position>(3) == 3 && lanes_of<Position>(2) == 2 && lanes_of<RestTime>(3) == 1);

// ---------------------------------------------------------------- roles
struct Unknown {
    using role = int;
};
static_assert(Policy<Gravity> && Policy<SemiImplicitEuler> && Policy<Space<float, 2>> && Policy<Keep<InverseMass>> &&
              Policy<Drag>);
static_assert(!Policy<int> && !Policy<Unknown> && !Policy<Position>);
static_assert(PlaysRole<Gravity, roles::Force> && !PlaysRole<Gravity, roles::Effect> && !PlaysRole<int, roles::Force>);
static_assert(std::same_as<role_of<Drag>, roles::Effect> && std::is_void_v<role_of<int>>);
static_assert(count_of_role<roles::Force, Gravity, SemiImplicitEuler, Attraction, Drag> == 2 &&
              count_of_role<roles::Force> == 0);

// ---------------------------------------------------------------- properties
template <class Q>
concept TakenAsPosition = requires(const Q& q) {
    { position(q) } -> std::same_as<Given<Position, Q>>;
};
static_assert(TakenAsPosition<VectorQuantity<unit::Length>> && TakenAsPosition<VectorQuantity<unit::Length, 2, float>>);
static_assert(
    std::same_as<decltype(velocity(metres_per_second(1, 2))), Given<Velocity, VectorQuantity<unit::Velocity, 2>>>);
static_assert(std::same_as<decltype(mass(1.0f * kilogram))::column, InverseMass>);
static_assert(std::same_as<decltype(with<RestTime>(1.0 * second)), Given<RestTime, Quantity<unit::Time>>>);
static_assert(std::same_as<decltype(datum("text")), GivenDatum<const char*>>);
// A parameter of a policy is taken like the quantity that it is.
static_assert(std::same_as<decltype(mass(Parameter<unit::Mass>())), GivenMass<Quantity<unit::Mass>>>);

// ---------------------------------------------------------------- what is a world
// The facts that the sentences say, without the sentences: every list here would stop a compiler in `World`.
template <class... P>
constexpr bool counts =
    detail::CountFacts<P...>::ok && detail::all_counts_are_right(detail::modules_of<P...>{}, Types<P...>{});
static_assert(counts<SemiImplicitEuler> && counts<Gravity, SemiImplicitEuler, Space<float, 2>, Drag, Rest>);
static_assert(!counts<> && !counts<Gravity> && !counts<SemiImplicitEuler, Verlet>);
static_assert(!counts<SemiImplicitEuler, Space<>, Space<float, 2>> &&
              !counts<SemiImplicitEuler, Datum<int>, Datum<bool>>);
template <class Role> struct Plays {
    using role = Role;
};
using Broad = Plays<roles::Broadphase>;
using Narrow = Plays<roles::Narrowphase>;
using Answer = Plays<roles::Response>;
using Sieve = Plays<roles::Filter>;
static_assert(counts<SemiImplicitEuler, Broad, Narrow, Answer> &&
              counts<SemiImplicitEuler, Broad, Narrow, Answer, Sieve>);
static_assert(counts<SemiImplicitEuler, Answer, Broad, Answer, Narrow>); // a chain of responses
static_assert(!counts<SemiImplicitEuler, Broad> && !counts<SemiImplicitEuler, Narrow> &&
              !counts<SemiImplicitEuler, Answer>);
static_assert(!counts<SemiImplicitEuler, Broad, Narrow> && !counts<SemiImplicitEuler, Sieve>);
static_assert(!counts<SemiImplicitEuler, Broad, Broad, Narrow, Answer>);

static_assert(detail::stands_once<Gravity, Gravity, Drag> && !detail::stands_once<Gravity, Gravity, Drag, Gravity>);
static_assert(detail::RoleFacts<Gravity>::ok && !detail::RoleFacts<int>::ok && !detail::RoleFacts<Unknown>::ok);
struct CheckWithArgument : Plays<roles::Observer> {
    void check(int) const;
};
struct CheckNotConst : Plays<roles::Observer> {
    void check();
};
static_assert(!detail::RoleFacts<CheckWithArgument>::ok && !detail::RoleFacts<CheckNotConst>::ok);
static_assert(detail::TogetherFacts<SemiImplicitEuler, Attraction>::ok &&
              !detail::TogetherFacts<ImplicitEuler, Attraction>::ok);
static_assert(detail::TogetherFacts<ImplicitEuler, QuadraticDrag, Gravity>::ok);
static_assert(detail::is_world<SemiImplicitEuler, Gravity, Drag, Rest, Interpolation, Keep<InverseMass>, Datum<int>>);
static_assert(detail::is_world<Rest, Gravity, Space<float, 2>, Drag, SemiImplicitEuler>);

// A world is a value, and its type is what was listed.
using W = World<SemiImplicitEuler, Gravity>;
static_assert(std::copyable<W> && std::is_nothrow_move_constructible_v<Lanes<Space<>, Columns<Position>>>);
static_assert(std::same_as<decltype(World{SemiImplicitEuler{}, Gravity{}}), W>);
static_assert(std::same_as<decltype(std::declval<const W&>().position(Handle{})), VectorQuantity<unit::Length>>);
static_assert(std::same_as<W::Scalar, double> &&
              std::same_as<World<Verlet, Space<float, 2>>::Velocity, VectorQuantity<unit::Velocity, 2, float>>);
static_assert(!std::convertible_to<SemiImplicitEuler, World<SemiImplicitEuler>>); // not by accident

} // namespace
