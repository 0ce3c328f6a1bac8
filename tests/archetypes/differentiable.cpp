// SPDX-License-Identifier: BSL-1.0
// DifferentiableIn: archetypes, two models, near misses.

#include "tests/archetypes/archetype.hpp"

namespace ansatz::archetypes {

using S = Space<>;

struct WithJacobian : NothingMore {
    using NothingMore::NothingMore;
    using role = roles::Force;
    using reads = Columns<Position>;
    template <class> struct In : NothingMore {
        explicit In(const WithJacobian&) : NothingMore(0) {}
        S::Acceleration acceleration(const S::Position&, const Context<S, false>&) const { return {}; }
        Jacobian<S> jacobian(const S::Position&, const Context<S, false>&) const { return {}; }
    };
};
/// A law that depends on nothing that an integrator solves for needs none.
struct WithoutMotion : NothingMore {
    using NothingMore::NothingMore;
    using role = roles::Force;
    using reads = Columns<Clock, InverseMass>;
    template <class> struct In : NothingMore {
        explicit In(const WithoutMotion&) : NothingMore(0) {}
        S::Acceleration acceleration(const S::InverseMass&, const Context<S, true>&) const { return {}; }
    };
};
static_assert(DifferentiableIn<WithJacobian, S> && DifferentiableIn<WithoutMotion, S>);
auto of_derivatives() { return use(World{ImplicitEuler{}, WithJacobian(1), WithoutMotion(1)}); }

static_assert(DifferentiableIn<QuadraticDrag, Space<float, 2>> && DifferentiableIn<Gravity, S>);

// Near misses: no derivative, half of one, one with other arguments; and a force between bodies.
template <class Derivative> struct Candidate {
    using role = roles::Force;
    using reads = Columns<Position>;
    template <class Sp> struct In : Derivative {
        explicit In(const Candidate&);
        typename Sp::Acceleration acceleration(const typename Sp::Position&, const auto&) const;
    };
};
struct None {};
struct Half {
    struct OnlyPosition {
        int position;
    };
    OnlyPosition jacobian(const auto&, const auto&) const;
};
struct OfAnotherArity {
    Jacobian<S> jacobian(const auto&) const;
};
struct Changing {
    Jacobian<S> jacobian(const auto&, const auto&);
};
static_assert(LawIn<Candidate<None>, S> && LawIn<Candidate<Half>, S>);
static_assert(!DifferentiableIn<Candidate<None>, S> && !DifferentiableIn<Candidate<Half>, S> && !DifferentiableIn<Candidate<OfAnotherArity>, S> &&
              !DifferentiableIn<Candidate<Changing>, S> && !DifferentiableIn<Attraction, S> && !DifferentiableIn<Drag, S>);

} // namespace ansatz::archetypes
