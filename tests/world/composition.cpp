// SPDX-License-Identifier: BSL-1.0
// The order of policies means nothing: every order of a list is the same world, to the same hash.

#include <ansatz/world/composition.hpp>

#include "tests/catch.hpp"
#include "tests/world/worlds.hpp"

#include <set>

using namespace ansatz;
using namespace ansatz::test;

namespace {

/// The hash, after a hundred steps of a short life, of the world of these policies in this order.
template <class... P> std::uint64_t hash_of(const P&... policies) {
    World world{policies...};
    for (int i = 0; i < 5; ++i)
        world.add(position(metres(i, -i, 1)), velocity(metres_per_second(1, i, 0.5)), with<Heat>(i * joule));
    for (int i = 0; i < 100; ++i) world.step((i % 9 == 8 ? 1.0 / 120 : 1.0 / 60) * second);
    return world.hash();
}

/// Calls `f` with every order of the policies behind the first `Done`.
template <class F, class... Done> void every_order(F& f, const std::tuple<Done...>& done, const std::tuple<>&) {
    std::apply(f, done);
}
template <class F, class... Done, class... Left>
    requires(sizeof...(Left) > 0)
void every_order(F& f, const std::tuple<Done...>& done, const std::tuple<Left...>& left) {
    [&]<std::size_t... I>(std::index_sequence<I...>) {
        auto take = [&]<std::size_t At>(std::integral_constant<std::size_t, At>) {
            auto others = std::tuple_cat([&]<std::size_t K>(std::integral_constant<std::size_t, K>) {
                if constexpr (K == At) return std::tuple<>();
                else return std::tuple(std::get<K>(left));
            }(std::integral_constant<std::size_t, I>{})...);
            every_order(f, std::tuple_cat(done, std::tuple(std::get<At>(left))), others);
        };
        (take(std::integral_constant<std::size_t, I>{}), ...);
    }(std::make_index_sequence<sizeof...(Left)>{});
}

} // namespace

TEST_CASE("all twenty-four orders of four policies are one world after a hundred steps", "[world][composition]") {
    std::set<std::uint64_t> seen;
    int orders = 0;
    auto run = [&](const auto&... policies) {
        ++orders;
        seen.insert(hash_of(policies...));
    };
    // Two forces, whose sum does not depend on the order to the last bit, and columns whose order does follow the list.
    every_order(run, std::tuple<>(), std::tuple(SemiImplicitEuler{}, ToOrigin{}, Gravity{}, Keep<Heat, Position>{}));
    CHECK(orders == 24);
    CHECK(seen.size() == 1);
    CHECK(seen.count(hash_of(SemiImplicitEuler{}, ToOrigin{}, Gravity{metres_per_second_squared(0, -1, 0)},
                             Keep<Heat, Position>{})) == 0);
}

namespace {
template <class... P> using Facts = Composition<P...>;
using S = Space<>;
template <class List, class... C>
constexpr bool holds = List::size == sizeof...(C) && (detail::contains<C, List> && ...);
} // namespace

// Which columns a world stores follows from its policies, and from nothing else.
static_assert(holds<Facts<SemiImplicitEuler>::stored, Position, Velocity>);
static_assert(
    holds<Facts<SemiImplicitEuler, Gravity, Drag, StopBelow, FrameDrag, Space<float, 2>>::stored, Position, Velocity>);
static_assert(
    holds<Facts<SemiImplicitEuler, QuadraticDrag>::stored, Position, Velocity, InverseMass>); // a force needs the mass
static_assert(holds<Facts<SemiImplicitEuler, AppliedForces>::stored, Position, Velocity, InverseMass, AppliedForce>);
static_assert(holds<Facts<SemiImplicitEuler, Rest>::stored, Position, Velocity, RestTime>);
static_assert(holds<Facts<SemiImplicitEuler, Interpolation>::stored, Position, Velocity, DrawnPosition>);
static_assert(holds<Facts<Verlet>::stored, Position, PreviousPosition>);
static_assert(holds<Facts<Verlet, Drag, QuadraticDrag>::stored, Position, PreviousPosition,
                    InverseMass>); // the velocity is derived in a register
static_assert(
    holds<Facts<RungeKutta4, Later>::stored, Position, Velocity>); // scratch lives in registers, a clock nowhere
static_assert(holds<Facts<SemiImplicitEuler, Nothing>::stored, Position, Velocity, CoupledForce, InverseMass>);
static_assert(Facts<RungeKutta4, Nothing>::stored::size ==
              4 + 4); // its four scratch columns, where it must wait between stages
static_assert(holds<Facts<RungeKutta4, Nothing>::state, Position, Velocity,
                    InverseMass>); // which are no state, nor are the sums of forces
static_assert(holds<Facts<Verlet, Nothing>::stored, Position, PreviousPosition, CoupledForce, InverseMass>);
static_assert(holds<Facts<Verlet, Nothing, QuadraticDrag>::state, Position, PreviousPosition, InverseMass>);

static_assert(Facts<Verlet>::history && !Facts<SemiImplicitEuler>::history);
static_assert(Facts<SemiImplicitEuler, Rest>::rests && !Facts<SemiImplicitEuler, StopBelow>::rests);
static_assert(Facts<SemiImplicitEuler, Attraction>::coupled && !Facts<SemiImplicitEuler, Gravity>::coupled);
static_assert(Facts<SemiImplicitEuler, Keep<InverseMass>>::has_mass && !Facts<SemiImplicitEuler, Gravity>::has_mass);
static_assert(std::same_as<Facts<Gravity, Verlet, Space<float, 2>>::Integrator, Verlet>);
static_assert(std::same_as<Facts<Gravity, Verlet, Space<float, 2>>::S, Space<float, 2>>);
static_assert(std::same_as<Facts<Verlet>::S, Space<double, 3>>);
static_assert(Facts<Gravity, SemiImplicitEuler, Attraction, AppliedForces>::laws::size == 2);
static_assert(
    std::same_as<Facts<SemiImplicitEuler, Drag, StopBelow>::effects<Place::after_integration>, Types<Drag, StopBelow>>);
static_assert(Facts<SemiImplicitEuler, Drag>::effects<Place::before_forces>::size == 0);
static_assert(holds<Facts<SemiImplicitEuler, AppliedForces>::transient, AppliedForce>);
static_assert(Facts<SemiImplicitEuler, Gravity>::transient::size == 0);
