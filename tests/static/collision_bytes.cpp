// SPDX-License-Identifier: BSL-1.0
// No effect, no byte (rows N), where bodies collide: no friction, no restitution, no layers and no forces between
// bodies unless somebody asks for them. And the facts about a list of policies, without the sentences.

#include <ansatz/collision.hpp>
#include <ansatz/collision/check.hpp>
#include <ansatz/collision/concepts.hpp>
#include <ansatz/world.hpp>

#include <cstddef>

using namespace ansatz;

namespace {

template <class... Response>
using Colliding = World<SemiImplicitEuler, Gravity, BoundingBoxes, Narrowphase<Sphere, Plane>, Response...>;
template <class... Response> constexpr std::size_t bytes = Colliding<Response...>::bytes_per_body;
template <class C, class... Response> constexpr bool stores = Colliding<Response...>::composition::template stores<C>;
constexpr std::size_t number = sizeof(double), motion = 6 * number;

// Whoever moves bodies apart needs their masses; an impulse their restitution too; friction is asked for.
static_assert(bytes<Projection> == motion + number);
static_assert(bytes<Impulse<>> == motion + 2 * number);
static_assert(bytes<Impulse<>, Projection> == bytes<Impulse<>>);
static_assert(bytes<SoftSubsteps<>> == bytes<Impulse<>>);
static_assert(bytes<Impulse<Friction>> == bytes<Impulse<>> + number &&
              bytes<SoftSubsteps<Friction>> == bytes<SoftSubsteps<>> + number);
static_assert(!stores<Restitution, Projection> && !stores<Friction, Projection> && stores<Restitution, Impulse<>> &&
              !stores<Friction, Impulse<>>);
static_assert(stores<Friction, Impulse<Friction>> && !stores<Friction, SoftSubsteps<>> &&
              stores<Friction, SoftSubsteps<Friction>>);
static_assert(!stores<Restitution, Penalty> &&
              !stores<Friction, Penalty>); // a contact's own spring and damper say how it bounces

// Forces between bodies have a column only where contacts are such forces.
static_assert(bytes<Penalty> == motion + number + 3 * number && stores<CoupledForce, Penalty>);
static_assert(!stores<CoupledForce, Impulse<>> && !stores<CoupledForce, SoftSubsteps<Friction>>);

// Layers: two columns, and none without the filter. Rest: how long a body has been slow.
static_assert(!stores<Member, Impulse<>> && !stores<Ignored, Impulse<>> && stores<Member, Impulse<>, Layers> &&
              stores<Ignored, Impulse<>, Layers>);
static_assert(bytes<Impulse<>, Layers> == bytes<Impulse<>> + 2 * number &&
              bytes<Impulse<>, Rest> == bytes<Impulse<>> + number);

// What is kept between steps, beside the contacts: nothing by Impulse and Projection; friction's share only with
// friction.
static_assert(Colliding<Impulse<Friction>, Projection>::composition::keepers::size == 0 &&
              Colliding<SoftSubsteps<>>::composition::keepers::size == 1);
// A pass reads a contact as one line of the cache.
static_assert(sizeof(SoftContacts<Space<>, false>::Constraint) == 64);
static_assert(sizeof(SoftContacts<Space<>, true>::Constraint) - sizeof(SoftContacts<Space<>, false>::Constraint) ==
              4 * number);
static_assert(SoftContacts<Space<>, false>::numbers_each == 5 && SoftContacts<Space<>, true>::numbers_each == 8);

// A world without collisions has nothing of them in it, and one with them everything.
static_assert(sizeof(World<SemiImplicitEuler, Gravity>) + 100 < sizeof(Colliding<Impulse<>>));
static_assert(!World<SemiImplicitEuler, Gravity>::composition::collides && Colliding<Impulse<>>::composition::collides);

// ---------------------------------------------------------------- what is a world
template <class... P>
constexpr bool counts = detail::CollisionCounts<SemiImplicitEuler, BoundingBoxes, Narrowphase<Sphere>, P...>::ok;
static_assert(counts<Impulse<>> && counts<Impulse<>, Projection> && counts<Penalty, Projection> &&
              counts<SoftSubsteps<>> && counts<SoftSubsteps<>, Projection>);
static_assert(!counts<SoftSubsteps<>, SoftSubsteps<Friction>> && !counts<SoftSubsteps<>, Penalty> && !counts<>);
static_assert(counts<Layers, Impulse<>> && !counts<Layers> && !counts<Impulse<>, SortAndSweep> &&
              !counts<Impulse<>, Narrowphase<Plane, Sphere>>);
static_assert(!counts<Layers, Impulse<>, Penalty, SoftSubsteps<>>);

} // namespace
