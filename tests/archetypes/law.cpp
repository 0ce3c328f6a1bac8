// SPDX-License-Identifier: BSL-1.0
// LawIn and ForceIn: an archetype of each answer, two models, near misses.

#include "tests/archetypes/archetype.hpp"

namespace ansatz::archetypes {

using S = Space<>;

/// Answers with an acceleration.
struct AccelerationLaw : NothingMore {
    using NothingMore::NothingMore;
    using role = roles::Force;
    using reads = Columns<Position>;
    template <class> struct In : NothingMore {
        explicit In(const AccelerationLaw&) : NothingMore(0) {}
        S::Acceleration acceleration(const S::Position&, const Context<S, false>&) const { return {}; }
    };
};
/// Answers with a force, knows the time and prepares.
struct ForceLaw : NothingMore {
    using NothingMore::NothingMore;
    using role = roles::Force;
    using reads = Columns<Clock, Velocity>;
    template <class> struct In : NothingMore {
        explicit In(const ForceLaw&) : NothingMore(0) {}
        void prepare(const Context<S, true>&) {}
        S::Force force(const S::Velocity&, const Context<S, true>&) const { return {}; }
    };
};
static_assert(LawIn<AccelerationLaw, S> && ForceIn<AccelerationLaw, S> && !CouplingIn<AccelerationLaw, S>);
static_assert(LawIn<ForceLaw, S> && ForceIn<ForceLaw, S>);
auto of_acceleration() { return use(World{SemiImplicitEuler{}, AccelerationLaw(1)}); }
auto of_force() { return use(World{Verlet{}, ForceLaw(1), AccelerationLaw(1)}); }

// Models, in spaces of any scalar and dimension.
static_assert(LawIn<Gravity, Space<float, 2>> && LawIn<Gravity, S>);
static_assert(LawIn<QuadraticDrag, Space<double, 2>> && LawIn<AppliedForces, Space<float, 3>>);

// Near misses.
struct NoColumns {
    using role = roles::Force;
    template <class Sp> struct In {
        explicit In(const NoColumns&);
        typename Sp::Acceleration acceleration(const auto&) const;
    };
};
struct AnswersVelocity {
    using role = roles::Force;
    using reads = Columns<>;
    template <class Sp> struct In {
        explicit In(const AnswersVelocity&);
        typename Sp::Velocity acceleration(const auto&) const;
    };
};
struct WithoutContext {
    using role = roles::Force;
    using reads = Columns<Position>;
    template <class Sp> struct In {
        explicit In(const WithoutContext&);
        typename Sp::Acceleration acceleration(const typename Sp::Position&) const;
    };
};
struct NotConst {
    using role = roles::Force;
    using reads = Columns<>;
    template <class Sp> struct In {
        explicit In(const NotConst&);
        typename Sp::Acceleration acceleration(const auto&);
    };
};
struct PreparesWrongly {
    using role = roles::Force;
    using reads = Columns<>;
    template <class Sp> struct In {
        explicit In(const PreparesWrongly&);
        void prepare();
        typename Sp::Acceleration acceleration(const auto&) const;
    };
};
struct OtherRole {
    using role = roles::Effect;
    using reads = Columns<>;
    template <class Sp> struct In {
        explicit In(const OtherRole&);
        typename Sp::Acceleration acceleration(const auto&) const;
    };
};
struct NotFromThePolicy {
    using role = roles::Force;
    using reads = Columns<>;
    template <class Sp> struct In {
        typename Sp::Acceleration acceleration(const auto&) const;
    };
};
static_assert(!LawIn<NoColumns, S> && !LawIn<AnswersVelocity, S> && !LawIn<WithoutContext, S> && !LawIn<NotConst, S>);
static_assert(!LawIn<PreparesWrongly, S> && !LawIn<OtherRole, S> && !LawIn<NotFromThePolicy, S> && !LawIn<int, S> &&
              !LawIn<Attraction, S>);
static_assert(!ForceIn<NoColumns, S> && !ForceIn<SemiImplicitEuler, S> && !ForceIn<Drag, S>);

} // namespace ansatz::archetypes
