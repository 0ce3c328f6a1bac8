// SPDX-License-Identifier: BSL-1.0
// StagedIntegratorIn, SolvingIntegratorIn and IntegratorIn: archetypes, models, near misses.

#include "tests/archetypes/archetype.hpp"

namespace ansatz::archetypes {

using S = Space<>;

/// One stage, and nothing but position and velocity.
struct OneStaged : NothingMore {
    using NothingMore::NothingMore;
    using role = roles::Integrator;
    using writes = Columns<Position, Velocity>;
    static constexpr int stages = 1;
    static void advance(Stage<0>, S::Position&, S::Velocity&, const S::Acceleration&, const TimeStep<S>&) {}
};
/// Two stages, scratch, nodes, and a history instead of a velocity.
struct OfHistory : NothingMore {
    using NothingMore::NothingMore;
    using role = roles::Integrator;
    using writes = Columns<PreviousPosition, Position>;
    using scratch = Columns<ScratchVector<unit::Length>>;
    static constexpr int stages = 2;
    static void advance(Stage<0>, S::Position&, S::Position&, S::Position&, const S::Acceleration&,
                        const TimeStep<S>&) {}
    static void advance(Stage<1>, S::Position&, S::Position&, S::Position&, const S::Acceleration&,
                        const TimeStep<S>&) {}
    static S::Velocity mean_velocity(const S::Position&, const S::Position&, const S::Time&) { return {}; }
    static S::Velocity velocity_now(const S::Velocity&, const S::Acceleration&, const S::Time&) { return {}; }
    static S::Position history(const S::Position&, const S::Velocity&, const S::Acceleration&, const S::Time&) {
        return {};
    }
};
/// Solves for the next state.
struct OneThatSolves : NothingMore {
    using NothingMore::NothingMore;
    using role = roles::Integrator;
    using writes = Columns<Position, Velocity>;
    static bool solve(S::Position& x, S::Velocity& v, const auto& laws, const TimeStep<S>&) {
        const S::Acceleration a = laws(x, v, 0.5);
        return a == S::Acceleration();
    }
};
static_assert(StagedIntegratorIn<OneStaged, S> && IntegratorIn<OneStaged, S> && !SolvingIntegratorIn<OneStaged, S>);
static_assert(StagedIntegratorIn<OfHistory, S> && IntegratorIn<OfHistory, S>);
static_assert(SolvingIntegratorIn<OneThatSolves, S> && IntegratorIn<OneThatSolves, S> &&
              !StagedIntegratorIn<OneThatSolves, S>);
auto of_one_stage() { return use(World{OneStaged(1), Gravity{}, Drag{}}); }
auto of_history() { return use(World{OfHistory(1), Gravity{}, Drag{}}); }
auto of_history_coupled() { return use(World{OfHistory(1), Attraction{}, QuadraticDrag{}}); }
auto of_solving() { return use(World{OneThatSolves(1), Gravity{}, Drag{}}); }

static_assert(StagedIntegratorIn<RungeKutta4, Space<float, 2>> && StagedIntegratorIn<Verlet, Space<float, 3>>);
static_assert(SolvingIntegratorIn<ImplicitEuler, S> && SolvingIntegratorIn<ImplicitEuler, Space<float, 2>>);

// Near misses of staged ones.
struct LacksAStage {
    using role = roles::Integrator;
    using writes = Columns<Position, Velocity>;
    static constexpr int stages = 2;
    static void advance(Stage<0>, auto& x, auto& v, const auto& a, const auto& dt);
};
struct ByValue {
    using role = roles::Integrator;
    using writes = Columns<Position, Velocity>;
    static constexpr int stages = 1;
    static void advance(Stage<0>, auto& x, S::Velocity v, const auto& a, const auto& dt);
};
struct HistoryWithoutItsMeaning {
    using role = roles::Integrator;
    using writes = Columns<Position, PreviousPosition>;
    static constexpr int stages = 1;
    static void advance(Stage<0>, auto& x, auto& previous, const auto& a, const auto& dt);
};
struct WithoutPosition {
    using role = roles::Integrator;
    using writes = Columns<Velocity>;
    static constexpr int stages = 1;
    static void advance(Stage<0>, auto& v, const auto& a, const auto& dt);
};
struct ForgetsScratch {
    using role = roles::Integrator;
    using writes = Columns<Position, Velocity>;
    using scratch = Columns<ScratchVector<unit::Velocity>>;
    static constexpr int stages = 1;
    static void advance(Stage<0>, auto& x, auto& v, const auto& a, const auto& dt);
};
static_assert(!IntegratorIn<LacksAStage, S> && !IntegratorIn<ByValue, S> &&
              !IntegratorIn<HistoryWithoutItsMeaning, S> && !IntegratorIn<WithoutPosition, S> &&
              !IntegratorIn<ForgetsScratch, S> && !IntegratorIn<Gravity, S>);

// Near misses of those that solve.
struct AnswersNothing {
    using role = roles::Integrator;
    using writes = Columns<Position, Velocity>;
    static void solve(auto& x, auto& v, const auto& laws, const auto& dt);
};
struct OfHistoryThatSolves {
    using role = roles::Integrator;
    using writes = Columns<Position, PreviousPosition>;
    static bool solve(auto& x, auto& v, const auto& laws, const auto& dt);
};
struct SolvesACopy {
    using role = roles::Integrator;
    using writes = Columns<Position, Velocity>;
    static bool solve(const auto& x, auto& v, const auto& laws, const auto& dt);
};
static_assert(!IntegratorIn<AnswersNothing, S> && !IntegratorIn<OfHistoryThatSolves, S> &&
              !IntegratorIn<SolvesACopy, S>);

} // namespace ansatz::archetypes
