// SPDX-License-Identifier: BSL-1.0
// No effect, no byte (rows N): what a body takes in the lanes, and a world by itself, follows from what it was asked
// for.

#include <ansatz/world.hpp>

#include <cstddef>

using namespace ansatz;

namespace {

template <class... P> constexpr std::size_t bytes = World<P...>::bytes_per_body;
template <class Scalar, int Dim> constexpr std::size_t vector = sizeof(Scalar) * Dim;

// Position and velocity, in every space.
static_assert(bytes<SemiImplicitEuler> == 2 * vector<double, 3>);
static_assert(bytes<SemiImplicitEuler, Space<double, 2>> == 2 * vector<double, 2>);
static_assert(bytes<SemiImplicitEuler, Space<float, 3>> == 2 * vector<float, 3>);
static_assert(bytes<SemiImplicitEuler, Space<float, 2>> == 2 * vector<float, 2>);

// Whatever acts on what is there already costs a body nothing.
static_assert(bytes<SemiImplicitEuler, Gravity, Drag, FrameDrag, StopBelow> == bytes<SemiImplicitEuler>);
static_assert(bytes<ExplicitEuler> == bytes<RungeKutta4> &&
              bytes<VelocityVerlet> == bytes<ImplicitEuler>);         // scratch lives in registers
static_assert(bytes<Verlet, Gravity, Drag> == 2 * vector<double, 3>); // history instead of a velocity, not beside it
static_assert(bytes<SemiImplicitEuler, Datum<char[1000]>> == bytes<SemiImplicitEuler>); // not in the lanes

// What needs something of its own costs that and no more.
static_assert(bytes<SemiImplicitEuler, QuadraticDrag> == bytes<SemiImplicitEuler> + sizeof(double)); // the mass
static_assert(bytes<SemiImplicitEuler, Keep<InverseMass>> == bytes<SemiImplicitEuler, QuadraticDrag>);
static_assert(bytes<SemiImplicitEuler, Keep<InverseMass>, QuadraticDrag> ==
              bytes<SemiImplicitEuler, QuadraticDrag>); // and not twice
static_assert(bytes<SemiImplicitEuler, AppliedForces> == bytes<SemiImplicitEuler, QuadraticDrag> + vector<double, 3>);
static_assert(bytes<SemiImplicitEuler, Rest> == bytes<SemiImplicitEuler> + sizeof(double));
static_assert(bytes<SemiImplicitEuler, Interpolation> == bytes<SemiImplicitEuler> + vector<double, 3>);
static_assert(bytes<SemiImplicitEuler, Attraction> == bytes<SemiImplicitEuler, QuadraticDrag> + vector<double, 3>);
static_assert(bytes<RungeKutta4, Attraction> ==
              bytes<SemiImplicitEuler, Attraction> + 4 * vector<double, 3>); // waits between its stages
static_assert(bytes<Keep<InverseMass>, Space<float, 2>, Verlet> == 2 * vector<float, 2> + sizeof(float));

// The world itself: an empty policy adds nothing to it, and the order of the policies neither.
template <class... P> constexpr std::size_t size = sizeof(World<P...>);
static_assert(size<SemiImplicitEuler, Gravity, Interpolation> == size<SemiImplicitEuler, Gravity>);
static_assert(size<SemiImplicitEuler, Gravity, Keep<InverseMass>> == size<SemiImplicitEuler, Gravity>);
static_assert(size<SemiImplicitEuler, Gravity, AppliedForces> == size<SemiImplicitEuler, Gravity>);
static_assert(size<SemiImplicitEuler, Gravity, Space<double, 3>> == size<SemiImplicitEuler, Gravity>);
static_assert(size<RungeKutta4> == size<SemiImplicitEuler> && size<ExplicitEuler> == size<SemiImplicitEuler>);
static_assert(size<SemiImplicitEuler, Gravity> <
              size<SemiImplicitEuler, Gravity, Drag>); // parameters have to be somewhere
static_assert(size<SemiImplicitEuler, Gravity> < size<SemiImplicitEuler, Gravity, Rest>); // and so have events
static_assert(size<Drag, Gravity, SemiImplicitEuler> == size<SemiImplicitEuler, Gravity, Drag>);
static_assert(size<SemiImplicitEuler> < size<Verlet>); // the starts of history

} // namespace
