// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// One body through one step: the kernels that join an integrator, the laws and the per-body effects.
///
/// Where nothing couples bodies, `WholeStep` runs all stages of a body at once, in registers, and touches each lane
/// once. Where something couples, the world runs `OneStage` over all bodies, stage by stage, and the scratch between
/// stages becomes columns. An integrator is written once, for one body, and does not know which of the two runs it.

#include <ansatz/motion/laws.hpp>
#include <ansatz/world/row.hpp>

#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>

namespace ansatz {

/// Names a stage in the overloads of an integrator's `advance`: `advance(Stage<0>, x, v, a, dt)`.
template <int Number> struct Stage {};

/// Where in the step an effect acts.
enum class Place {
    before_forces,     ///< on the state that the step starts from
    after_integration, ///< on the state that the integrator has just made, before contacts are searched for
    end_of_step        ///< when everything else has been done
};

/// What a step does with `OwnAcceleration`, the acceleration of a body by the laws, in the first stage.
enum class LawsAsked {
    here,      ///< the laws are asked, for the integrator alone
    and_left,  ///< the laws are asked, and their answers are kept for what follows the integration
    beforehand ///< the driver of the substeps has asked them already, for the same state
};

namespace detail {

template <class I> struct Scratch {
    using type = Columns<>;
};
template <class I>
    requires requires { typename I::scratch; }
struct Scratch<I> {
    using type = typename I::scratch;
};
template <class I> using scratch_of = typename Scratch<I>::type;

/// An integrator that keeps no Velocity column derives the velocity from what it keeps.
template <class I> inline constexpr bool derives_velocity = !contains<Velocity, writes_of<I>>;

/// An integrator of stages has `advance`; one that solves (implicit, foreign steppers) has `solve`.
template <class I> inline constexpr bool is_staged = requires { I::stages; };

template <class I> constexpr int stage_count() {
    if constexpr (is_staged<I>) return I::stages;
    return 0;
}
template <class I> constexpr int first_stage(bool velocity_read) {
    if constexpr (requires { I::first_stage(velocity_read); }) return I::first_stage(velocity_read);
    return 0;
}
/// The fraction of dt at which stage `k` asks the laws.
template <class I> constexpr double node(int k) {
    if constexpr (requires { I::nodes[0]; }) return I::nodes[k];
    return 0;
}

/// No degree of freedom beside translation.
struct NoDegrees {
    using writes = Columns<>;
    using needs = Columns<>;
    static constexpr bool empty = true;
    template <class> using scratch = Columns<>;
    using coasting = NoDegrees;
    NoDegrees without_acceleration() const { return {}; }
};

/// What the laws say in a stage.
template <LawsAsked How, class LawsT, class R, class S>
[[gnu::always_inline]] inline auto own_acceleration(const LawsT& laws, R& row, const Context<S>& context) {
    if constexpr (How == LawsAsked::here) return laws.acceleration(row, context);
    else {
        if constexpr (How == LawsAsked::and_left) row.template get<OwnAcceleration>() = laws.acceleration(row, context);
        return typename S::Acceleration(row.template get<OwnAcceleration>());
    }
}

/// Where an integrator has its verbs: in its `In<S>` where it has parameters, which is bound to a space like every
/// other policy; as static functions of its own where it has none.
template <class I, class S> struct VerbsOf {
    using type = I;
};
template <class I, class S>
    requires requires { typename Bound<I, S>; }
struct VerbsOf<I, S> {
    using type = Bound<I, S>;
};
template <class I, class S> using verbs_of = typename VerbsOf<I, S>::type;

/// An integrator in a step: of one without parameters nothing is kept.
template <class I, class S, class Verbs = verbs_of<I, S>> struct BoundIntegrator {
    explicit BoundIntegrator(const I& integrator) : verbs(integrator) {}
    Verbs verbs;
};
template <class I, class S> struct BoundIntegrator<I, S, I> {
    BoundIntegrator() = default;
    explicit BoundIntegrator(const I&) {}
};

template <class I, int K, class S, class R, class... W, class... X, class A, class Dt>
[[gnu::always_inline]] inline void advance([[maybe_unused]] const BoundIntegrator<I, S>& integrator, R& row,
                                           Columns<W...>, Columns<X...>, const A& a, const Dt& dt) {
    if constexpr (requires { integrator.verbs; })
        integrator.verbs.advance(Stage<K>{}, row.template get<W>()..., row.template get<X>()..., a, dt);
    else I::advance(Stage<K>{}, row.template get<W>()..., row.template get<X>()..., a, dt);
}

/// The integrator whose lines advance a body: a wrapper (Compensated) says around which it is, by the type `Inner` and
/// the member `integrator`, both in itself and where it is bound.
template <class I> [[gnu::always_inline]] constexpr const auto& plain_integrator(const I& integrator) {
    if constexpr (requires {
                      typename I::Inner;
                      integrator.integrator;
                  })
        return plain_integrator(integrator.integrator);
    else return integrator;
}
template <class I> using plain_integrator_of = std::remove_cvref_t<decltype(plain_integrator(std::declval<I>()))>;
template <class I, class S> // the same, bound
[[gnu::always_inline]] inline const auto& plain_integrator(const BoundIntegrator<I, S>& bound) {
    if constexpr (requires {
                      typename I::Inner;
                      bound.verbs.integrator;
                  })
        return plain_integrator(bound.verbs.integrator);
    else return bound;
}

/// Stage `K` of all degrees of freedom: what accelerates them is asked before any of them moves.
template <class I, int K, class S, class Degrees, class R, class A>
[[gnu::always_inline]] inline void advance_all(const BoundIntegrator<I, S>& integrator,
                                               [[maybe_unused]] const Degrees& degrees, R& row, const A& a,
                                               [[maybe_unused]] const Context<S>& stage, const TimeStep<S>& dt) {
    if constexpr (Degrees::empty) advance<I, K>(integrator, row, writes_of<I>{}, scratch_of<I>{}, a, dt);
    else {
        const auto others = degrees.accelerations(row, stage);
        advance<I, K>(integrator, row, writes_of<I>{}, scratch_of<I>{}, a, dt);
        degrees.template advance<I, K>(integrator, row, others, dt);
    }
}

/// The velocity of a body whose integrator derives it, into the row's Velocity: the mean over the last step.
template <class I, class R, class T> [[gnu::always_inline]] inline void derive_velocity(R& row, const T& over) {
    if constexpr (derives_velocity<I>)
        row.template get<Velocity>() =
            I::mean_velocity(row.template get<Position>(), row.template get<PreviousPosition>(), over);
}

/// A force from outside ends with its step. Where velocity is derived from history, the next step would see half of its
/// impulse only, since each step contributes half of the acceleration at its beginning and half of that at its end; the
/// history takes the other half before the force is gone.
template <class I, class Transient, class R, class T>
[[gnu::always_inline]] inline void release_applied_force(R& row, const T& dt) {
    if constexpr (derives_velocity<I> && contains<AppliedForce, Transient>) {
        auto& previous = row.template get<PreviousPosition>();
        using X = std::remove_cvref_t<decltype(previous)>;
        using V = std::remove_cvref_t<decltype(row.template get<Velocity>())>;
        const auto a = row.template get<InverseMass>() * row.template get<AppliedForce>();
        previous += I::history(zero<X>(), zero<V>(), -a, dt);
    }
}

/// Calls a per-body effect with what it declared: references to what it writes, values of what it reads.
template <class E, class S, class R, class... W, class... C>
[[gnu::always_inline]] inline void apply_one(const Bound<E, S>& effect, R& row, Columns<W...>, Columns<C...>,
                                             const Context<S>& context) {
    effect.apply(row.template get<W>()..., std::as_const(row).template get<C>()...,
                 context.template restricted<reads_clock<E>>());
}

} // namespace detail

/// The per-body effects `E...` of one place of the step, in space `S`.
template <class S, class... E> class Effects {
public:
    using writes = union_of<writes_of<E>...>;
    using reads = union_of<writes_of<E>..., reads_of<E>...>;
    static constexpr bool empty = sizeof...(E) == 0; ///< whether there are none

    /// Binds them to the space.
    explicit Effects(const E&... policies) : effects_(detail::Bound<E, S>(policies)...) {}

    /// What can be computed once for all bodies, as a factor of the step.
    void prepare([[maybe_unused]] const Context<S>& context) {
        [[maybe_unused]] auto one = [](auto& effect, const auto& limited) {
            if constexpr (requires { effect.prepare(limited); }) effect.prepare(limited);
        };
        (one(std::get<detail::place_of<E, List>>(effects_), context.template restricted<detail::reads_clock<E>>()),
         ...);
    }

    /// Acts on one body. What an effect does to the velocity or the position of a body goes through the integrator:
    /// where velocity is derived from history, a body that was only moved must not gain speed, and one that was only
    /// slowed must not jump.
    /// \param over the time between the body's previous and present position
    template <class I, class R>
    [[gnu::always_inline]] void apply(R& row, const Context<S>& context, const typename S::Time& over) const {
        if constexpr (!empty) {
            constexpr bool history = detail::derives_velocity<I>;
            constexpr bool velocity = detail::contains<Velocity, writes>;
            constexpr bool position = detail::contains<Position, writes>;
            if constexpr (history && detail::contains<Velocity, reads>) detail::derive_velocity<I>(row, over);
            typename S::Velocity old_velocity{};
            typename S::Position old_position{};
            if constexpr (history && velocity) old_velocity = row.template get<Velocity>();
            if constexpr (history && position) old_position = row.template get<Position>();
            apply_all(row, context);
            if constexpr (history && position)
                row.template get<PreviousPosition>() += row.template get<Position>() - old_position;
            if constexpr (history && velocity) keep_or_kick(row, old_velocity, over);
        }
    }
    /// The same for a body whose history has not begun: in its place stands the velocity that it was given.
    template <class I, class R>
    [[gnu::always_inline]] void apply_before_history(R& row, const Context<S>& context) const {
        static_assert(detail::derives_velocity<I>);
        row.template get<Velocity>() = S::Velocity::from_value(row.template get<PreviousPosition>().value());
        apply_all(row, context);
        row.template get<PreviousPosition>() = S::Position::from_value(row.template get<Velocity>().value());
    }

private:
    using List = std::tuple<E...>;

    template <class R> [[gnu::always_inline]] void apply_all(R& row, const Context<S>& context) const {
        (detail::apply_one<E, S>(std::get<detail::place_of<E, List>>(effects_), row, writes_of<E>{},
                                 difference_of<reads_of<E>, union_of<writes_of<E>, Columns<Clock>>>{}, context),
         ...);
    }

    // A component that no effect changed keeps its history to the bit: a null effect must be the same as none.
    template <class R>
    [[gnu::always_inline]] static void keep_or_kick(R& row, const typename S::Velocity& old,
                                                    const typename S::Time& over) {
        const auto& x = row.template get<Position>().value();
        const auto& v = row.template get<Velocity>().value();
        auto previous = row.template get<PreviousPosition>().value();
        for (int i = 0; i < S::dimension; ++i)
            previous[i] = v[i] == old.value()[i] ? previous[i] : x[i] - v[i] * over.value();
        row.template get<PreviousPosition>() = S::Position::from_value(previous);
    }

    std::tuple<detail::Bound<E, S>...> effects_;
};

/// The laws as an integrator that solves sees them: functions of position, velocity and the fraction of the step; the
/// other columns of the body stay as they are.
template <class S, class LawsT, class R> class LawsOfBody {
public:
    /// The laws, the body and the step.
    LawsOfBody(const LawsT& laws, const R& row, const Context<S>& context)
        : laws_(laws), row_(row), context_(context) {}

    /// The acceleration at another state, `fraction` of the step on.
    typename S::Acceleration operator()(const typename S::Position& x, const typename S::Velocity& v,
                                        double fraction) const {
        return laws_.acceleration(at(x, v), context_.later(fraction));
    }
    /// Its derivatives there.
    Jacobian<S> jacobian(const typename S::Position& x, const typename S::Velocity& v, double fraction) const {
        return laws_.jacobian(at(x, v), context_.later(fraction));
    }

private:
    R at(const typename S::Position& x, const typename S::Velocity& v) const {
        R row = row_;
        row.template get<Position>() = x;
        row.template get<Velocity>() = v;
        return row;
    }
    const LawsT& laws_;
    const R& row_;
    const Context<S>& context_;
};

/// All of one body's step, every stage with its forces, effects. For worlds where nothing couples.
template <class S, class I, class LawsT, class Before, class After, class Transient, LawsAsked How = LawsAsked::here,
          class Degrees = detail::NoDegrees>
struct WholeStep {
    /// Whether a force asks for the velocity.
    static constexpr bool velocity_read = detail::contains<Velocity, typename LawsT::reads>;
    static constexpr bool inlines = detail::is_staged<I>; ///< it is one kernel: the loop inlines it

    LawsT laws;              ///< the sum of the forces
    Before before;           ///< the effects before the integrator
    After after;             ///< those after it
    Context<S> context;      ///< time and step
    std::uint64_t* unsolved; ///< counts the bodies whose equation an implicit integrator could not solve
    detail::BoundIntegrator<I, S> integrator{}; ///< its parameters, where it has any
    Degrees degrees{};                          ///< what else is advanced

    /// One body's whole step.
    template <class R> [[gnu::always_inline]] void operator()(R& row, std::size_t) const {
        before.template apply<I>(row, context, context.dt().previous);
        detail::derive_velocity<I>(row, context.dt().previous);
        if constexpr (detail::is_staged<I>)
            stages(row,
                   std::make_integer_sequence<int, detail::stage_count<I>() - detail::first_stage<I>(velocity_read)>{});
        else solve(row);
        detail::release_applied_force<I, Transient>(row, context.dt());
        after.template apply<I>(row, context, context.dt());
        clear(row, Transient{});
    }

private:
    template <class R> void solve(R& row) const {
        const R start = row;
        auto& x = row.template get<Position>();
        auto& v = row.template get<Velocity>();
        const LawsOfBody<S, LawsT, R> of_body(laws, start, context);
        bool solved = false;
        if constexpr (requires { integrator.verbs; }) solved = integrator.verbs.solve(x, v, of_body, context.dt());
        else solved = I::solve(x, v, of_body, context.dt());
        if (!solved) ++*unsolved;
    }
    template <class R, int... K> [[gnu::always_inline]] void stages(R& row, std::integer_sequence<int, K...>) const {
        (stage<K + detail::first_stage<I>(velocity_read)>(row), ...);
    }
    template <int K, class R> [[gnu::always_inline]] void stage(R& row) const {
        constexpr LawsAsked how = K == detail::first_stage<I>(velocity_read) ? How : LawsAsked::here;
        const auto a = detail::own_acceleration<how>(laws, row, context.later(detail::node<I>(K)));
        detail::advance_all<I, K>(integrator, degrees, row, a, context.later(detail::node<I>(K)), context.dt());
    }
    template <class R, class... C> [[gnu::always_inline]] static void clear(R& row, Columns<C...>) {
        ((row.template get<C>() = value_of<C, S>()), ...);
    }
};

/// Stage `K` of one body, with the coupled force that was summed for it. For worlds where something couples.
template <class S, class I, int K, class LawsT, LawsAsked How = LawsAsked::here, class Degrees = detail::NoDegrees>
struct OneStage {
    /// It is one kernel: the loop inlines it.
    static constexpr bool inlines = true;

    LawsT laws;                                 ///< the sum of the laws of one body
    Context<S> context;                         ///< time and step
    detail::BoundIntegrator<I, S> integrator{}; ///< its parameters, where it has any
    Degrees degrees{};                          ///< what else is advanced

    /// One body's stage.
    template <class R> [[gnu::always_inline]] void operator()(R& row, std::size_t) const {
        const auto own = detail::own_acceleration<How>(laws, row, context.later(detail::node<I>(K)));
        const auto coupled = row.template get<InverseMass>() * row.template get<CoupledForce>();
        detail::advance_all<I, K>(integrator, degrees, row, own + coupled, context.later(detail::node<I>(K)),
                                  context.dt());
    }
};

/// Effects alone, over all bodies: where a step runs stage by stage, and at the end of every step.
template <class S, class I, class EffectsT, class Transient> struct EffectsOnly {
    /// It is one kernel: the loop inlines it.
    static constexpr bool inlines = true;

    EffectsT effects;      ///< the effects
    Context<S> context;    ///< time and step
    typename S::Time over; ///< the time over which they act, s

    /// One body's effects.
    template <class R> [[gnu::always_inline]] void operator()(R& row, std::size_t) const {
        detail::release_applied_force<I, Transient>(row, over);
        effects.template apply<I>(row, context, over);
        clear(row, Transient{});
    }

private:
    template <class R, class... C> [[gnu::always_inline]] static void clear(R& row, Columns<C...>) {
        ((row.template get<C>() = value_of<C, S>()), ...);
    }
};

/// Effects where velocity is derived, after something has given some of the bodies a velocity.
/// \tparam Data says which, `data.waiting(slot)`
template <class S, class I, class EffectsT, class Data> struct EffectsBetweenHistories {
    EffectsT effects;      ///< the effects
    Context<S> context;    ///< time and step
    typename S::Time over; ///< the time between the previous and the present positions of the others, s
    const Data* data;      ///< of the world

    /// One body's effects.
    template <class R> void operator()(R& row, std::size_t slot) const {
        if (data->waiting(std::uint32_t(slot))) effects.template apply_before_history<I>(row, context);
        else effects.template apply<I>(row, context, over);
    }
};

} // namespace ansatz
