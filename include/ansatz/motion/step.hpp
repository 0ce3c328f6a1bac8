// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What motion does in a step:
///
///     histories begin -> effects -> [ forces -> integrator ] x stages -> effects -> platforms
///
/// It composes and owns no algorithm: laws, stages and effects are the policies', the loop is `for_lanes`. Where
/// nothing couples bodies, the bracket and the effects around it are one loop that touches each lane once; where
/// something couples, they run stage by stage.

#include <ansatz/motion/bound_motion.hpp>
#include <ansatz/motion/coupled_system.hpp>
#include <ansatz/motion/coupling.hpp>
#include <ansatz/motion/state.hpp>
#include <ansatz/world/execution.hpp>
#include <ansatz/world/step.hpp>

#include <atomic>
#include <cstdint>

namespace ansatz {

namespace detail {
template <class T, std::size_t M, std::size_t N>
constexpr std::array<T, M + N> joined(const std::array<T, M>& a, const std::array<T, N>& b) {
    std::array<T, M + N> both{};
    for (std::size_t i = 0; i < M + N; ++i) both[i] = i < M ? a[i] : b[i - M];
    return both;
}
} // namespace detail

template <class StepT> class MotionStep;
template <class StepT> void wake_pulled(MotionStep<StepT>& motion); // rest_step.hpp

/// Motion in a step, or in a substep.
template <class StepT> class MotionStep {
public:
    using C = typename StepT::Composition_;     ///< of the world
    using Policies = typename StepT::Policies_; ///< of the world
    using S = typename C::S;                    ///< the space
    using I = typename C::Integrator;           ///< the integrator
    using Data = WorldData<C>;                  ///< what the step works on
    using Slot = typename Data::Slot;           ///< a body's place in the lanes
    using Scalar = typename S::Scalar;
    using Transient = typename StepT::Transient; ///< set back to zero behind the step

    /// Of this step.
    explicit MotionStep(StepT& step)
        : step_(step), data_(step.data), policies_(step.policies), bound_(step.bound), context_(step.context) {}

    /// Forces, integrator and the effects around it, and platforms.
    void integrate() {
        if constexpr (C::asked == LawsAsked::beforehand) know_own(context_);
        if constexpr (C::history) complete_starts();
        if constexpr (C::together) all_together();
        else if constexpr (C::coupled) stage_by_stage();
        else body_by_body();
        advance_platforms();
        // The sums are those of the places before: where a driver takes the step in substeps, the next substep asks
        // anew.
        if constexpr (C::coupled) data_.coupled.current = false;
        if constexpr (C::history) data_.last_substep = context_.dt();
        if constexpr (C::asked == LawsAsked::beforehand) data_.own.value.known = false;
    }
    /// The step.
    StepT& step() const { return step_; }
    /// A row system of a policy, over the awake bodies.
    template <class E> void row_system(const E& policy) {
        Effects<S, E> one(policy);
        one.prepare(context_);
        effects_between(one);
        if constexpr (couplings_see(writes_of<E>{})) data_.coupled.current = false;
        if constexpr (C::asked == LawsAsked::beforehand &&
                      intersection_of<writes_of<E>, typename C::Laws::needs>::size > 0)
            data_.own.value.known = false;
    }
    /// Effects of the whole step.
    void effects_at_the_end() { effects_between(bound_.end); }

    /// \name What the laws say, asked once
    /// A substep that needs accelerations before the integrator does asks the laws here; the integrator takes
    /// in its first stage what they said. Forces of velocity are those of the velocity at the beginning of the substep,
    /// for both.
    /// @{

    /// Asks the laws about every awake body as it stands, unless that is known.
    /// \param then when that is, and how long the substep was that led here
    void know_own(const Context<S>& then) {
        if (data_.own.value.known) return;
        ask_laws(then, then.dt().previous, [](Slot, const auto&) {});
    }
    /// Asks them about the state that a substep has just made. Where velocity is derived, a law that reads it is
    /// told the mean brought to the present by half a step of what the laws said at the beginning.
    void know_own_again(const Context<S>& then) {
        ask_laws(then, then.dt().previous, [&](Slot slot, auto& row) {
            if constexpr (C::history && detail::contains<Velocity, typename C::Laws::reads>)
                if (!data_.waiting(slot))
                    row.template get<Velocity>() =
                        I::velocity_now(row.template get<Velocity>(), own_acceleration(slot), then.dt().previous);
        });
    }
    /// The acceleration of one body by all forces, the laws having been asked.
    typename S::Acceleration known_acceleration(Slot slot) const {
        typename S::Acceleration a = own_acceleration(slot);
        if constexpr (C::coupled)
            a += data_.lanes.template get<InverseMass>(slot) * data_.lanes.template get<CoupledForce>(slot);
        return a;
    }
    /// What the laws said.
    typename S::Acceleration own_acceleration(Slot slot) const {
        return data_.own.value.lanes.template get<OwnAcceleration>(slot);
    }
    /// @}

    /// The acceleration of one body as it stands.
    typename S::Acceleration acceleration(Slot slot, const typename Data::Body& row) const {
        return acceleration_at(slot, row, context_);
    }
    /// The same, at another time.
    typename S::Acceleration acceleration_at(Slot slot, const typename Data::Body& row,
                                             const Context<S>& context) const {
        typename S::Acceleration a = bound_.laws.acceleration(row, context);
        if constexpr (C::coupled)
            a += data_.lanes.template get<InverseMass>(slot) * data_.lanes.template get<CoupledForce>(slot);
        return a;
    }

    /// What holds bodies together breaks where the state that was made is too much for it.
    void let_break() {
        derive_velocities(data_, policies_, context_.dt());
        [&]<class... Q>(Types<Q...>) { (let_break_one<Q>(), ...); }(typename C::breakers{});
    }

    /// Bodies that were given a velocity where the integrator keeps history: now it can begin.
    void complete_starts() {
        if (data_.starts.list.empty()) return;
        refresh_coupled(data_, policies_, context_);
        for (const auto id : data_.starts.list) {
            if (!data_.starts.waiting(id)) { // gone since
                data_.starts.state[id] = detail::Starts::begun;
                continue;
            }
            const Slot slot = data_.bodies.slot_of_id(id);
            const auto row = data_.load(slot);
            const bool pulled = data_.bodies.motion(slot) == Motion::awake;
            const auto a = pulled ? acceleration_at_start(slot, row) : typename S::Acceleration();
            data_.lanes.template set<PreviousPosition>(
                slot,
                I::history(row.template get<Position>(), row.template get<Velocity>(), a, context_.dt().previous));
            data_.starts.state[id] = detail::Starts::begun;
        }
        data_.starts.list.clear();
        // The velocities that a force between bodies reads are derived from the histories that have just begun.
        if constexpr (C::coupled && C::template stores<Velocity>) data_.coupled.current = false;
    }

protected:
    /// Whether a force between bodies sees one of them.
    template <class... Column> static constexpr bool couplings_see(Columns<Column...>) {
        return (C::template couplings_read<Column> || ...);
    }
    /// The columns that a kernel loads are stored ones; the others it needs live in the row alone.
    template <class Needs> using loaded = intersection_of<Needs, typename C::stored>;
    /// Those others.
    template <class Needs> using locals = difference_of<Needs, typename C::stored>;
    /// What is derived before anything reads it.
    using derived = std::conditional_t<C::history, Columns<Velocity>, Columns<>>;

    /// Effects alone.
    template <class Transient_, class EffectsT>
    void effects_only(const EffectsT& effects, const typename S::Time& over, Motion range = Motion::awake) {
        using Written = std::conditional_t<C::history, union_of<typename EffectsT::writes, Transient_, writes_of<I>>,
                                           union_of<typename EffectsT::writes, Transient_>>;
        using Needs = union_of<Written, typename EffectsT::reads, derived,
                               std::conditional_t<Transient_::size != 0, Columns<InverseMass>, Columns<>>>;
        walk<Needs, Written>(range, EffectsOnly<S, I, EffectsT, Transient_>{effects, context_, over});
    }
    /// The same before or behind the integrator's own loops, where something may have given bodies a velocity.
    template <class EffectsT> void effects_between(const EffectsT& effects) {
        if constexpr (C::history) {
            using Written = union_of<typename EffectsT::writes, writes_of<I>>;
            using Needs = union_of<Written, typename EffectsT::reads, derived>;
            const auto last = data_.last_substep; // none before the first step
            const auto over = last.value() > Scalar(0) ? last : typename S::Time(context_.dt());
            if (data_.starts.none()) return effects_only<Columns<>>(effects, over);
            walk<Needs, Written>(Motion::awake,
                                 EffectsBetweenHistories<S, I, EffectsT, Data>{effects, context_, over, &data_});
        } else effects_only<Columns<>>(effects, context_.dt());
    }
    /// One loop over the bodies of a kind.
    template <class Needs, class Written, class Kernel> void walk(Motion range, const Kernel& kernel) {
        const std::size_t begin = data_.bodies.begin(range), end = data_.bodies.end(range);
        if constexpr (C::executed) {
            std::atomic<std::uint64_t> unsolved = 0;
            in_ranges<C>(policies_, begin, end, [&](std::size_t first, std::size_t last) {
                Kernel part = kernel;
                std::uint64_t of_part = 0;
                if constexpr (requires { part.unsolved; }) part.unsolved = &of_part;
                walk_slots<Needs, Written>(first, last, part);
                if (of_part != 0) unsolved += of_part;
            });
            data_.unsolved += unsolved;
        } else walk_slots<Needs, Written>(begin, end, kernel);
    }
    /// The same over some of them.
    template <class Needs, class Written, class Kernel>
    void walk_slots(std::size_t begin, std::size_t end, const Kernel& kernel) {
        using Load = loaded<Needs>;
        if constexpr (detail::contains<OwnAcceleration, Needs>) {
            using Own = Columns<OwnAcceleration>;
            for_lanes<S, union_of<Load, Own>, Written, difference_of<locals<Needs>, Own>>(
                detail::joined(data_.lanes.pointers(Load{}), data_.own.value.lanes.pointers(Own{})), begin, end,
                kernel);
        } else for_lanes<S, Load, Written, locals<Needs>>(data_.lanes.pointers(Load{}), begin, end, kernel);
    }

    StepT& step_;             ///< the step
    Data& data_;              ///< the world
    Policies& policies_;      ///< its policies
    BoundPolicies<C>& bound_; ///< prepared for this substep
    Context<S>& context_;     ///< when it begins, and how long it is

private:
    /// In a row of the first stage stands what the laws say, if it is known or left.
    using own_read = std::conditional_t<C::asked == LawsAsked::here, Columns<>, Columns<OwnAcceleration>>;
    using own_written = std::conditional_t<C::asked == LawsAsked::and_left, Columns<OwnAcceleration>, Columns<>>;

    /// Asks the laws about every awake body, of which `see` may bring the values up to date.
    template <class See>
    [[gnu::flatten]] void ask_laws(const Context<S>& then, const typename S::Time& last, const See& see) {
        auto& own = data_.own.value;
        make_room_for_own();
        in_ranges<C>(policies_, 0, data_.bodies.end(Motion::awake), [&](std::size_t begin, std::size_t end) {
            for (std::size_t slot = begin; slot < end; ++slot) {
                auto row = data_.load(Slot(slot), last);
                see(Slot(slot), row);
                own.lanes.template set<OwnAcceleration>(slot, bound_.laws.acceleration(row, then));
            }
        });
        own.known = true;
    }
    /// Of a body, if they have been asked already; it is asked alone otherwise.
    typename S::Acceleration acceleration_at_start(Slot slot, const typename Data::Body& row) const {
        if constexpr (C::asked == LawsAsked::beforehand)
            if (data_.own.value.known) return known_acceleration(slot);
        return acceleration(slot, row);
    }

    void body_by_body() {
        using Kernel = WholeStep<S, I, typename C::Laws, decltype(bound_.before), decltype(bound_.after), Transient,
                                 C::asked, typename C::Degrees>;
        using Written = union_of<writes_of<I>, typename C::Degrees::writes, typename decltype(bound_.before)::writes,
                                 typename decltype(bound_.after)::writes, Transient, own_written>;
        using Needs = union_of<Written, typename C::Laws::needs, typename C::Degrees::needs,
                               typename decltype(bound_.before)::reads, typename decltype(bound_.after)::reads,
                               detail::scratch_of<I>, typename C::Degrees::template scratch<I>, derived, own_read>;
        make_room_for_own();
        walk<Needs, Written>(Motion::awake, Kernel{bound_.laws, bound_.before, bound_.after, context_, &data_.unsolved,
                                                   bound_.integrator, bound_.degrees});
    }

    /// All bodies as one system of equations.
    void all_together() {
        effects_before();
        if constexpr (C::stages_wake) {
            refresh_coupled(data_, policies_, context_);
            wake_pulled(*this);
        }
        remember_platforms(data_);
        CoupledSystem<C, Policies> system(data_, policies_, bound_.laws, context_);
        bool solved = false;
        if constexpr (requires { bound_.integrator.verbs; })
            solved = data_.together.value.solve(system, context_.dt(), bound_.integrator.verbs);
        else solved = data_.together.value.solve(system, context_.dt());
        if (!solved) ++data_.unsolved;
        place_platforms(data_, 0, context_.dt());
        effects_after();
    }

    /// A copy begins without room.
    void make_room_for_own() {
        if constexpr (C::asked != LawsAsked::here) {
            auto& own = data_.own.value;
            if (own.lanes.room() < data_.bodies.end(Motion::awake)) own.reserve(data_.bodies.end(Motion::awake));
        }
    }
    void stage_by_stage() {
        effects_before();
        remember_platforms(data_);
        [&]<int... K>(std::integer_sequence<int, K...>) {
            (stage<K + first_stage>(), ...);
        }(std::make_integer_sequence<int, detail::stage_count<I>() - first_stage>{});
        place_platforms(data_, 0, context_.dt());
        effects_after();
    }
    void effects_before() {
        if constexpr (StepT::later)
            effects_before([&]<class... E>(Types<E...>) {
                return bound_now<E...>();
            }(typename C::template in_every_part<typename C::template effects<Place::before_forces>>{}));
        else effects_before(bound_.before);
    }
    template <class EffectsT> void effects_before(const EffectsT& effects) {
        if constexpr (!EffectsT::empty) {
            effects_only<Columns<>>(effects, context_.dt().previous);
            // Most of them (Interpolation) write what no force between bodies sees.
            if constexpr (couplings_see(typename EffectsT::writes{})) data_.coupled.current = false;
        }
    }
    template <class... E> Effects<S, E...> bound_now() const {
        Effects<S, E...> effects(std::get<E>(policies_)...);
        effects.prepare(context_);
        return effects;
    }
    void effects_after() {
        if constexpr (!decltype(bound_.after)::empty || Transient::size > 0)
            effects_only<Transient>(bound_.after, context_.dt());
    }

    static constexpr int first_stage = detail::first_stage<I>(C::velocity_read);

    template <int K> void stage() {
        if constexpr (K == first_stage && detail::node<I>(K) == 0) refresh_coupled(data_, policies_, context_);
        else {
            if constexpr (K == first_stage) derive_velocities(data_, policies_, context_.dt().previous);
            place_platforms(data_, detail::node<I>(K), context_.dt());
            sum_coupled(data_, policies_, context_.later(detail::node<I>(K)));
        }
        if constexpr (K == first_stage && C::stages_wake) {
            [[maybe_unused]] const std::size_t awake = data_.bodies.end(Motion::awake);
            wake_pulled(*this);
            if constexpr (C::asked == LawsAsked::beforehand)
                if (data_.bodies.end(Motion::awake) != awake) {
                    data_.own.value.known = false;
                    know_own(context_);
                }
            if constexpr (C::history)
                if (!data_.starts.list.empty()) {
                    complete_starts();
                    derive_velocities(data_, policies_, context_.dt().previous);
                }
        }
        constexpr LawsAsked how = K == first_stage ? C::asked : LawsAsked::here;
        using Written = union_of<writes_of<I>, typename C::Degrees::writes, typename C::scratch,
                                 std::conditional_t<how == LawsAsked::and_left, own_written, Columns<>>>;
        using Needs = union_of<Written, detail::scratch_of<I>, typename C::Laws::needs, typename C::Degrees::needs,
                               Columns<CoupledForce, InverseMass>,
                               std::conditional_t<how == LawsAsked::here, Columns<>, own_read>>;
        if constexpr (how != LawsAsked::here) make_room_for_own();
        walk<Needs, Written>(Motion::awake, OneStage<S, I, K, typename C::Laws, how, typename C::Degrees>{
                                                bound_.laws, context_, bound_.integrator, bound_.degrees});
    }

    /// Platforms keep their velocity: the integrator's own stages without any acceleration.
    void advance_platforms() {
        if (data_.bodies.count(Motion::moving) == 0) return;
        [&]<class... E>(Types<E...>) {
            if constexpr (sizeof...(E) > 0)
                effects_only<Columns<>>(Effects<S, E...>(std::get<E>(policies_)...), context_.dt().previous,
                                        Motion::moving);
        }(std::conditional_t<StepT::later, typename C::template in_every_part<typename C::platform_effects>,
                             typename C::platform_effects>{});
        using Degrees = typename C::Degrees::coasting;
        using Coast = WholeStep<S, std::conditional_t<detail::is_staged<I>, I, detail::NoIntegrator>, Laws<S>,
                                Effects<S>, Effects<S>, Columns<>, LawsAsked::here, Degrees>;
        if constexpr (!detail::is_staged<I>) {
            for (auto slot = data_.bodies.begin(Motion::moving); slot < data_.bodies.end(Motion::moving); ++slot)
                data_.lanes.template set<Position>(slot, data_.lanes.template get<Position>(slot) +
                                                             data_.lanes.template get<Velocity>(slot) * context_.dt());
        } else {
            using Written = union_of<writes_of<I>, typename Degrees::writes>;
            walk<union_of<Written, detail::scratch_of<I>, typename Degrees::needs,
                          typename Degrees::template scratch<I>, derived>,
                 Written>(Motion::moving, Coast{Laws<S>(), Effects<S>(), Effects<S>(), context_, &data_.unsolved,
                                                bound_.integrator, bound_.degrees.without_acceleration()});
        }
    }

    template <class Q> void let_break_one() {
        const detail::Bound<Q, S> force(std::get<Q>(policies_));
        auto& state = data_.template state<Q>();
        const auto known = state.broken().size(); // in the substeps before this one
        force.breaking(step_.template view_of<Q>(), [&](std::uint32_t id, const auto& tension, const auto& strain) {
            state.note_broken(id, tension, strain, data_.bodies);
        });
        if (state.broken().size() == known) return;
        // The velocity now is what the forces made it, those of the broken ones too; what is left is made good.
        if constexpr (C::history) {
            data_.coupled.current = false;
            refresh_coupled(data_, policies_, step_.after());
            data_.coupled.changed = true;
        }
        state.erase_broken(known);
    }
};
template <class StepT> MotionStep(StepT&) -> MotionStep<StepT>; ///< of a step

} // namespace ansatz
