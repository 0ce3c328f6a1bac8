// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The step: the order in which a world's parts act, and nothing else.
///
///     starts -> effects -> [ forces -> integrator ] x stages -> effects -> platforms -> rest -> observers
///
/// It composes and owns no algorithm: laws, stages and effects are the policies', the loop is `sweep`. Where nothing
/// couples bodies, the bracket and the effects around it are one loop that touches each lane once; where something
/// couples, they run stage by stage. The step does not allocate, throw or print once the world is warm.

#include <ansatz/world/coupled_system.hpp>
#include <ansatz/world/coupling.hpp>
#include <ansatz/world/data.hpp>
#include <ansatz/world/view.hpp>

namespace ansatz {

/// The policies of a world, bound to its space.
template <class C> struct BoundPolicies {
    /// The space.
    using S = typename C::S;
    typename C::Laws laws;                                        ///< the forces
    typename C::template Effects<Place::before_forces> before;    ///< the effects before the integrator
    typename C::template Effects<Place::after_integration> after; ///< those after it
    typename C::template Effects<Place::end_of_step> end;         ///< those at the end of the step

    /// Binds a world's policies.
    template <class Policies> static BoundPolicies from(const Policies& policies) {
        return {bind<typename C::Laws>(policies, typename C::laws{}),
                bind<typename C::template Effects<Place::before_forces>>(
                    policies, typename C::template effects<Place::before_forces>{}),
                bind<typename C::template Effects<Place::after_integration>>(
                    policies, typename C::template effects<Place::after_integration>{}),
                bind<typename C::template Effects<Place::end_of_step>>(
                    policies, typename C::template effects<Place::end_of_step>{})};
    }
    /// What can be computed once for all bodies.
    void prepare(const Context<S>& context) {
        laws.prepare(context);
        before.prepare(context);
        after.prepare(context);
        end.prepare(context);
    }

private:
    template <class To, class Policies, class... Q> static To bind(const Policies& policies, Types<Q...>) {
        return To(std::get<Q>(policies)...);
    }
};

/// One step of a world's data under its policies.
template <class C, class Policies> class Step {
public:
    using S = typename C::S;          ///< the space
    using I = typename C::Integrator; ///< the integrator
    using Data = WorldData<C>;        ///< what the step works on
    using Slot = typename Data::Slot; ///< a body's place in the lanes
    using Scalar = typename S::Scalar;

    /// A step of these policies on this data.
    Step(Data& data, Policies& policies, const BoundPolicies<C>& bound, const TimeStep<S>& dt)
        : data_(data), policies_(policies), bound_(bound), context_(data.clock.now(), dt) {
        bound_.prepare(context_);
    }

    /// Forgets what the step before brought.
    static void begin(Data& data) {
        if constexpr (C::rests) data.events.begin_step();
        data.states.for_each([](auto& state) { state.begin_step(); });
    }
    /// Before it is decided how this step is taken: contacts that act in it are those of the bodies as they are now.
    void look_around();
    /// Takes it.
    /// \tparam Transient the columns that are set back to zero behind it: none where it is a part of a step and not the
    /// last
    /// \tparam Later     whether it is a part of a step and not the first
    template <class Transient = typename C::transient, bool Later = false> void run(const typename S::ClockTime& dt) {
        if constexpr (C::rests && C::Laws::time_dependent && !C::coupled) wake_the_pulled();
        if constexpr (C::islands) wake_neighbours();
        if constexpr (C::sweeps) data_.collisions.remember(data_);
        if constexpr (C::substeps) in_substeps<Transient, Later>();
        else integrate<Transient, Later>();
        if constexpr (C::collides) collide(Later);
        if constexpr (!decltype(bound_.end)::empty) effects_only<Columns<>>(bound_.end, context_.dt());
        data_.clock.advance(dt);
        if constexpr (C::breaks) let_break(typename C::breakers{});
        if constexpr (C::coupled) {
            // The forces of the state that was made: Rest looks at them, queries read them, the next step begins with
            // them.
            data_.coupled.current = false;
            refresh_coupled(data_, policies_, after());
        }
        if constexpr (C::islands) put_islands_to_rest();
        else if constexpr (C::rests) put_to_rest();
        observe(typename C::observers{});
    }

private:
    /// Forces, integrator and the effects around it, and platforms, over the step or a part of it.
    template <class Transient, bool Later> void integrate() {
        if constexpr (C::history) complete_starts();
        if constexpr (C::together) all_together<Transient, Later>();
        else if constexpr (C::coupled) stage_by_stage<Transient, Later>();
        else body_by_body<Transient>();
        advance_platforms<Later>();
    }

    // Where bodies collide: collisions_in_step.hpp.
    template <class Transient, bool Later> void in_substeps();
    void settle();
    void wake_neighbours();
    bool wake_the_hit(auto& contacts, Scalar h);
    void hold_back();
    void collide(bool later);
    void put_islands_to_rest();
    void add_pushes(const auto& add) const;

    /// The columns that a kernel loads are stored ones; the others it needs live in the row alone.
    template <class Needs> using loaded = intersection_of<Needs, typename C::stored>;
    template <class Needs> using locals = difference_of<Needs, typename C::stored>;
    using derived = std::conditional_t<C::history, Columns<Velocity>, Columns<>>;

    template <class... Column> static constexpr bool couplings_see(Columns<Column...>) {
        return (C::template couplings_read<Column> || ...);
    }

    template <class Needs, class Written, class Kernel> void walk(Motion range, const Kernel& kernel) {
        using Load = loaded<Needs>;
        sweep<S, Load, Written, locals<Needs>>(data_.lanes.pointers(Load{}), data_.bodies.begin(range),
                                               data_.bodies.end(range), kernel);
    }

    template <class Transient> void body_by_body() {
        using Kernel = WholeStep<S, I, typename C::Laws, decltype(bound_.before), decltype(bound_.after), Transient>;
        using Written = union_of<writes_of<I>, typename decltype(bound_.before)::writes,
                                 typename decltype(bound_.after)::writes, Transient>;
        using Needs = union_of<Written, typename C::Laws::needs, typename decltype(bound_.before)::reads,
                               typename decltype(bound_.after)::reads, detail::scratch_of<I>, derived>;
        walk<Needs, Written>(Motion::awake,
                             Kernel{bound_.laws, bound_.before, bound_.after, context_, &data_.unsolved});
    }

    /// All bodies as one system of equations.
    template <class Transient, bool Later> void all_together() {
        effects_before<Later>();
        if constexpr (C::rests) {
            refresh_coupled(data_, policies_, context_);
            wake_the_pulled();
        }
        remember_platforms(data_);
        CoupledSystem<C, Policies> system(data_, policies_, bound_.laws, context_);
        if (!data_.together.value.solve(system, context_.dt())) ++data_.unsolved;
        place_platforms(data_, 0, context_.dt());
        effects_after<Transient>();
    }

    template <class Transient, bool Later> void stage_by_stage() {
        effects_before<Later>();
        remember_platforms(data_);
        [&]<int... K>(std::integer_sequence<int, K...>) {
            (stage<K + first_stage>(), ...);
        }(std::make_integer_sequence<int, detail::stage_count<I>() - first_stage>{});
        place_platforms(data_, 0, context_.dt());
        effects_after<Transient>();
    }
    template <bool Later> void effects_before() {
        if constexpr (Later)
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
    template <class Transient> void effects_after() {
        if constexpr (!decltype(bound_.after)::empty || Transient::size > 0)
            effects_only<Transient>(bound_.after, context_.dt());
    }

    static constexpr int first_stage = detail::first_stage<I>(C::velocity_read);

    template <int K> void stage() {
        if constexpr (K == first_stage && detail::node<I>(K) == 0) refresh_coupled(data_, policies_, context_);
        else {
            if constexpr (K == first_stage) derive_velocities(data_, context_.dt().previous);
            place_platforms(data_, detail::node<I>(K), context_.dt());
            sum_coupled(data_, policies_, context_.later(detail::node<I>(K)));
        }
        if constexpr (K == first_stage && C::rests) {
            wake_the_pulled();
            if constexpr (C::history)
                if (!data_.starts.list.empty()) {
                    complete_starts();
                    derive_velocities(data_, context_.dt().previous);
                }
        }
        using Written = union_of<writes_of<I>, typename C::scratch>;
        using Needs =
            union_of<Written, detail::scratch_of<I>, typename C::Laws::needs, Columns<CoupledForce, InverseMass>>;
        walk<Needs, Written>(Motion::awake, OneStage<S, I, K, typename C::Laws>{bound_.laws, context_});
    }

    template <class Transient, class EffectsT>
    void effects_only(const EffectsT& effects, const typename S::Time& over, Motion range = Motion::awake) {
        using Written = std::conditional_t<C::history, union_of<typename EffectsT::writes, Transient, writes_of<I>>,
                                           union_of<typename EffectsT::writes, Transient>>;
        using Needs = union_of<Written, typename EffectsT::reads, derived,
                               std::conditional_t<Transient::size != 0, Columns<InverseMass>, Columns<>>>;
        walk<Needs, Written>(range, EffectsOnly<S, I, EffectsT, Transient>{effects, context_, over});
    }

    /// The acceleration of one body as it stands.
    typename S::Acceleration acceleration(Slot slot, const typename Data::Body& row) const {
        return acceleration_at(slot, row, context_);
    }
    typename S::Acceleration acceleration_at(Slot slot, const typename Data::Body& row,
                                             const Context<S>& context) const {
        typename S::Acceleration a = bound_.laws.acceleration(row, context);
        if constexpr (C::coupled)
            a += data_.lanes.template get<InverseMass>(slot) * data_.lanes.template get<CoupledForce>(slot);
        return a;
    }

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
            const auto a = pulled ? acceleration(slot, row) : typename S::Acceleration();
            data_.lanes.template set<PreviousPosition>(
                slot,
                I::history(row.template get<Position>(), row.template get<Velocity>(), a, context_.dt().previous));
            data_.starts.state[id] = detail::Starts::begun;
        }
        data_.starts.list.clear();
        // The velocities that a force between bodies reads are derived from the histories that have just begun.
        if constexpr (C::coupled && C::template stores<Velocity>) data_.coupled.current = false;
    }

    /// Platforms keep their velocity: the integrator's own stages without any acceleration.
    template <bool Later> void advance_platforms() {
        if (data_.bodies.count(Motion::moving) == 0) return;
        [&]<class... E>(Types<E...>) {
            if constexpr (sizeof...(E) > 0)
                effects_only<Columns<>>(Effects<S, E...>(std::get<E>(policies_)...), context_.dt().previous,
                                        Motion::moving);
        }(std::conditional_t<Later, typename C::template in_every_part<typename C::platform_effects>,
                             typename C::platform_effects>{});
        using Coast = WholeStep<S, std::conditional_t<detail::is_staged<I>, I, detail::NoIntegrator>, Laws<S>,
                                Effects<S>, Effects<S>, Columns<>>;
        if constexpr (!detail::is_staged<I>) {
            for (auto slot = data_.bodies.begin(Motion::moving); slot < data_.bodies.end(Motion::moving); ++slot)
                data_.lanes.template set<Position>(slot, data_.lanes.template get<Position>(slot) +
                                                             data_.lanes.template get<Velocity>(slot) * context_.dt());
        } else
            walk<union_of<writes_of<I>, detail::scratch_of<I>, derived>, writes_of<I>>(
                Motion::moving, Coast{Laws<S>(), Effects<S>(), Effects<S>(), context_, &data_.unsolved});
    }

    using Rester = typename detail::FirstOf<typename C::resters>::type;

    void put_to_rest(Slot slot) {
        data_.stop(slot);
        data_.events.in_step({Event::Kind::slept, data_.bodies.handle(slot)});
        data_.move(slot, Motion::resting);
        if constexpr (C::template couplings_read<Velocity>) data_.coupled.current = false;
    }
    /// A body rests when it has been slow for long enough and would stay: at velocity zero next to nothing pulls at it.
    void put_to_rest() {
        const detail::Bound<Rester, S> rest(std::get<Rester>(policies_));
        auto* time = data_.lanes.template lane<RestTime>();
        if constexpr (pull_varies) begin_anew(rest, [](std::size_t) { return false; });
        for (auto slot = Slot(data_.bodies.end(Motion::awake)); slot-- > data_.bodies.begin(Motion::awake);)
            if (rest.long_enough(S::Time::from_value(time[slot])) &&
                (pull_varies || balanced(rest, pull_at_rest(slot, after()))))
                put_to_rest(slot);
    }
    /// Whether a body may rest to which this acceleration remains.
    static bool balanced(const auto& rest, const typename S::Acceleration& remains) {
        if constexpr (requires { rest.balanced(remains); }) return rest.balanced(remains);
        else return remains == S::template zero_vector<unit::Acceleration>();
    }
    /// Whether what pulls at a body depends on where it is, or on the time.
    static constexpr bool pull_varies =
        C::coupled || C::Laws::time_dependent || detail::contains<Position, typename C::Laws::needs>;
    /// What swings is slow, and at its lowest point nothing pulls it: there its time must be balanced, too, not a
    /// moment of it.
    /// \param touched whether a contact may hold the body of a slot
    void begin_anew(const auto& rest, const auto& touched) {
        auto* time = data_.lanes.template lane<RestTime>();
        for (std::size_t slot = 0; slot < data_.bodies.end(Motion::awake); ++slot)
            if (time[slot] > Scalar(0) && !touched(slot) && !balanced(rest, pull_at_rest(Slot(slot), after())))
                time[slot] = Scalar(0);
    }
    /// Behind the step that was taken: the next one, if it has the same length.
    Context<S> after() const { return Context<S>(data_.clock.now(), TimeStep<S>(context_.dt(), context_.dt())); }
    typename S::Acceleration pull_at_rest(Slot slot, const Context<S>& context) const {
        auto row = data_.load(slot);
        row.template get<Velocity>() = S::template zero_vector<unit::Velocity>();
        typename S::Acceleration a = bound_.laws.acceleration(row, context);
        if constexpr (C::coupled)
            a += data_.lanes.template get<InverseMass>(slot) * data_.lanes.template get<CoupledForce>(slot);
        return a;
    }

    /// What holds bodies together breaks where the state that was made is too much for it.
    template <class... Q> void let_break(Types<Q...>) {
        derive_velocities(data_, context_.dt());
        (let_break_one<Q>(), ...);
    }
    template <class Q> void let_break_one() {
        const detail::Bound<Q, S> force(std::get<Q>(policies_));
        auto& state = data_.template state<Q>();
        const auto known = state.broken().size(); // in the parts of a step that were taken before
        force.breaking(view_of<Q>(), [&](std::uint32_t id, const auto& tension, const auto& strain) {
            state.note_broken(id, tension, strain, data_.bodies);
        });
        if (state.broken().size() == known) return;
        // The velocity now is what the forces made it, those of the broken ones too; what is left is made good.
        if constexpr (C::history) {
            data_.coupled.current = false;
            refresh_coupled(data_, policies_, after());
            data_.coupled.changed = true;
        }
        state.erase_broken(known);
    }

    /// Whether what pulls at a resting body leaves it where it is: it is next to nothing, or what its contacts held
    /// when it fell asleep.
    bool stays(Slot slot) {
        const auto pull = pull_at_rest(slot, context_);
        if constexpr (C::collides)
            if (pull == data_.collisions.pull_when_it_slept(data_.bodies.id(slot))) return true;
        return balanced(detail::Bound<Rester, S>(std::get<Rester>(policies_)), pull);
    }
    void wake_the_pulled() {
        for (auto slot = Slot(data_.bodies.end(Motion::resting)); slot-- > data_.bodies.begin(Motion::resting);) {
            if (stays(slot)) continue;
            wake_resting(data_, slot);
            // The body that took this slot was at the beginning of the range: look at it too, unless it is the one
            // woken.
            if (slot >= data_.bodies.begin(Motion::resting) && slot < data_.bodies.end(Motion::resting)) ++slot;
        }
    }

public:
    /// Takes a resting body back into the awake range, within a step.
    static Slot wake_resting(Data& data, Slot slot) {
        data.events.in_step({Event::Kind::woke, data.bodies.handle(slot)});
        data.lanes.template set<RestTime>(slot, S::Time::from_value(typename S::Scalar(0)));
        data.begin_again(slot);
        return data.move(slot, Motion::awake);
    }

private:
    template <class... O> void observe(Types<O...>) { (observe_one<O>(), ...); }
    template <class Q> ObserverView<S, Q> view_of() const {
        return {data_.lanes, data_.bodies, std::as_const(data_).template state<Q>(), data_.clock.now(),
                data_.clock.tick()};
    }
    template <class O> void observe_one() {
        const auto view = view_of<O>();
        if constexpr (requires { std::get<O>(policies_).observe(view); }) std::get<O>(policies_).observe(view);
    }

    Data& data_;
    Policies& policies_;
    BoundPolicies<C> bound_;
    Context<S> context_;
};

} // namespace ansatz

#include <ansatz/world/collisions_in_step.hpp>
