// SPDX-License-Identifier: BSL-1.0
// DifferentiableIn and, of forces between bodies, DifferentiableCouplingIn: archetypes, two models, near misses.

#include "tests/archetypes/archetype.hpp"

#include <ansatz/springs.hpp>

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

static_assert(DifferentiableIn<QuadraticDrag, Space<float, 2>> && DifferentiableIn<Gravity, S> &&
              DifferentiableIn<Gravity, Space<float, 2>>);

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
static_assert(!DifferentiableIn<Candidate<None>, S> && !DifferentiableIn<Candidate<Half>, S> &&
              !DifferentiableIn<Candidate<OfAnotherArity>, S> && !DifferentiableIn<Candidate<Changing>, S> &&
              !DifferentiableIn<Attraction, S> && !DifferentiableIn<Drag, S>);

struct CouplesWithJacobian : NothingMore {
    using NothingMore::NothingMore;
    using role = roles::Force;
    using reads = Columns<Position>;
    static constexpr bool couples_bodies = true;
    template <class> struct In : NothingMore {
        explicit In(const CouplesWithJacobian&) : NothingMore(0) {}
        void couple(CouplingView<S, CouplesWithJacobian>&, const Context<S, false>&) const {}
        template <class Add>
        void jacobian(const ObserverView<S, CouplesWithJacobian>&, const Context<S, false>&, Add&&) const {}
        template <class F> void stiffnesses(const ObserverView<S, CouplesWithJacobian>&, F&&) const {}
    };
};
static_assert(DifferentiableCouplingIn<CouplesWithJacobian, S> && !DifferentiableIn<CouplesWithJacobian, S>);
auto of_coupled_derivatives() { return use(World{ImplicitEuler{}, CouplesWithJacobian(1)}); }

static_assert(DifferentiableCouplingIn<Springs<>, S> && DifferentiableCouplingIn<Ropes<Breaking>, Space<float, 2>>);

// Near misses: no derivative, no bound of it, one that is not called with a view.
template <class Derivative> struct CouplingCandidate {
    using role = roles::Force;
    using reads = Columns<Position>;
    static constexpr bool couples_bodies = true;
    template <class Sp> struct In : Derivative {
        explicit In(const CouplingCandidate&);
        void couple(auto& view, const auto&) const;
    };
};
struct OnlyJacobian {
    void jacobian(const auto& view, const auto&, auto&& add) const;
};
struct OnlyStiffnesses {
    void stiffnesses(const auto& view, auto&& f) const;
};
struct WithoutView : OnlyStiffnesses {
    void jacobian(const auto&, auto&& add) const;
};
static_assert(CouplingIn<CouplingCandidate<None>, S> && !DifferentiableCouplingIn<CouplingCandidate<None>, S>);
static_assert(!DifferentiableCouplingIn<CouplingCandidate<OnlyJacobian>, S> &&
              !DifferentiableCouplingIn<CouplingCandidate<OnlyStiffnesses>, S>);
static_assert(!DifferentiableCouplingIn<CouplingCandidate<WithoutView>, S> && !DifferentiableCouplingIn<Attraction, S>);

} // namespace ansatz::archetypes
