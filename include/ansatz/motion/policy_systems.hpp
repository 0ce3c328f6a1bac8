// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Systems of policies: how a policy of your own takes part in the step, at a phase that it names.
///
/// A policy lists them, `template <class S> using systems = Types<Waves<S>, ...>;`. Each is made from the policy, says
/// its `phase` and its `name`, and is one of three kinds:
///
/// - a **row system** has `apply(written&..., read..., context)` for one body, like an effect, and is asked for every
///   awake body: `using writes = Columns<...>; using reads = Columns<...>;`
/// - a **table system** has `run(view, context)`: it sees the columns that it declares, what its policy keeps
///   (`view.state()`) and what other policies keep (`using sees = Types<...>`, `view.template state_of<Springs<>>()`),
///   and owns its loop: a wave step, a solver;
/// - a **driver** has `until`, a phase, and `run(view, dt, part)`: it owns the systems up to that phase, and calls
///   `part(h)` for each substep that it divides the step into, `part.last(h)` for the last one.
///
/// The velocity and the position of a body go through the integrator: `view.template set<Velocity>` and
/// `set<Position>` mean the same whatever it keeps.

#include <ansatz/motion/step.hpp>
#include <ansatz/world/edited_elements.hpp>
#include <ansatz/world/schedule.hpp>

#include <concepts>
#include <string_view>
#include <type_traits>
#include <utility>

namespace ansatz {

namespace detail {
/// Elements go or become others at the place where springs break.
template <class StepT> void elements_will_change(StepT& step) {
    using C = typename StepT::Composition_;
    if constexpr (C::coupled) {
        // The velocity now is what the forces made it, those of what goes, too; what is left is made good.
        if constexpr (C::history)
            if (!step.data.coupled.changed) {
                derive_velocities(step.data, step.policies, step.after().dt());
                step.data.coupled.current = false;
                refresh_coupled(step.data, step.policies, step.after());
                step.data.coupled.changed = true;
            }
        step.data.coupled.current = false;
    }
}
/// Divides a body: a new one takes a share of its mass and of the forces on it, and has all else of it.
/// \return its id
template <class StepT>
std::uint32_t divide_body(StepT& step, std::uint32_t id, const typename StepT::S::Scalar& share) {
    using C = typename StepT::Composition_;
    using Scalar = typename StepT::S::Scalar;
    elements_will_change(step);
    auto& data = step.data;
    const auto part = data.divide(id, share);
    const auto scale = [&](std::uint32_t of, const Scalar& by) {
        const auto slot = data.bodies.slot_of_id(of);
        if constexpr (C::has_mass) data.lanes.template lane<InverseMass>()[slot] /= by;
        for (int k = 0; k < StepT::S::dimension; ++k) {
            if constexpr (C::template stores<CoupledForce>) data.lanes.template lane<CoupledForce>(k)[slot] *= by;
            if constexpr (C::template stores<AppliedForce>) data.lanes.template lane<AppliedForce>(k)[slot] *= by;
        }
    };
    scale(part, share);
    scale(id, Scalar(1) - share);
    if constexpr (C::asked == LawsAsked::beforehand) data.own.value.known = false;
    return part;
}
/// Whether the datum of a list of policies, if there is one, can be copied for a body that comes of another.
template <class P> inline constexpr bool copies_one = true;
template <class P>
    requires is_datum<P>
inline constexpr bool copies_one<P> = std::is_copy_assignable_v<typename P::datum_type>;
template <class List> inline constexpr bool copies_datum = true;
template <class... P> inline constexpr bool copies_datum<Types<P...>> = (copies_one<P> && ...);
} // namespace detail

/// What a table system or a driver of policy `P` works on.
/// \tparam Y the system
template <class StepT, class P, class Y> class SystemView {
public:
    using C = typename StepT::Composition_; ///< of the world
    using S = typename C::S;                ///< the space
    using Slot = Bodies::Slot;              ///< a body's place in the lanes

    /// Of a step.
    explicit SystemView(StepT& step) : step_(step) {}

    /// \name Bodies: in slots 0 to size(), first the awake ones, then resting, moving, fixed
    /// @{

    /// How many there are.
    std::size_t size() const { return step_.data.bodies.size(); }
    /// The first slot of a kind.
    std::size_t begin(Motion m) const { return step_.data.bodies.begin(m); }
    /// Behind its last.
    std::size_t end(Motion m) const { return step_.data.bodies.end(m); }
    /// Whether the handle names a body that is there.
    bool contains(Handle h) const { return step_.data.bodies.contains(h); }
    /// Where that body is.
    Slot slot(Handle h) const { return step_.data.bodies.slot(h, "view"); }
    /// Where the body is that an element names.
    Slot slot(BodyId body) const { return step_.data.bodies.slot_of_id(body.id); }
    /// Where the body with this id is; it must be there.
    Slot slot_of_id(std::uint32_t id) const { return step_.data.bodies.slot_of_id(id); }
    /// The id of the body in a slot.
    std::uint32_t id(std::size_t slot) const { return step_.data.bodies.id(slot); }
    /// The handle of the body with this id.
    Handle handle_of_id(std::uint32_t id) const { return step_.data.bodies.handle(step_.data.bodies.slot_of_id(id)); }
    /// Awake, resting, moving or fixed.
    Motion motion(std::size_t slot) const { return step_.data.bodies.motion(slot); }
    /// Calls `f(slot)` for every body by id, an order that sleeping, waking and removal do not change.
    template <class F> void for_each(F&& f) const {
        for (std::uint32_t id = 0; id < step_.data.bodies.ids(); ++id)
            if (step_.data.bodies.alive(id)) f(std::size_t(step_.data.bodies.slot_of_id(id)));
    }
    /// The value of a declared column.
    template <class Column> value_of<Column, S> get(std::size_t slot) const {
        declared<Column, union_of<reads_of<Y>, writes_of<Y>>>();
        if constexpr (std::same_as<Column, Velocity>)
            return step_.data.load(Slot(slot), step_.context.dt().previous).template get<Velocity>();
        else return step_.data.lanes.template get<Column>(slot);
    }
    /// Gives a column that it `writes` a value. A body that sleeps is not woken by it.
    template <class Column> void set(std::size_t slot, const value_of<Column, S>& value) {
        declared<Column, writes_of<Y>>();
        if constexpr (std::same_as<Column, Velocity>) step_.data.set_velocity(Slot(slot), value);
        else if constexpr (std::same_as<Column, Position>)
            step_.data.displace(Slot(slot), value - step_.data.lanes.template get<Position>(slot));
        else step_.data.lanes.template set<Column>(slot, value);
        if constexpr (!std::same_as<Column, Velocity>)
            if (slot >= step_.data.bodies.end(Motion::awake)) step_.data.bodies.note_change(slot);
        if constexpr (C::template couplings_read<Column>) step_.data.coupled.current = false;
        if constexpr (C::asked == LawsAsked::beforehand && detail::contains<Column, typename C::Laws::needs>)
            step_.data.own.value.known = false;
    }
    /// @}

    /// What the policy keeps.
    auto& state() { return step_.data.template state<P>(); }
    /// A table of another policy, or one that a module names, if the system says that it `sees` it
    /// (world/seen_tables.hpp).
    template <class Q> const auto& table() const {
        return SeenTables<S, detail::sees_of<Y>>::in(std::as_const(step_.data)).template get<Q>();
    }
    /// The parameters of the policy.
    const P& policy() const { return std::get<P>(step_.policies); }

    /// \name What other policies keep, to change it (world/edited_elements.hpp)
    /// @{

    /// The elements of a type that the system says it `edits`, to read; `detail::absent` where no policy keeps them.
    template <class E> const auto& elements() const {
        edited<E>();
        return detail::elements_in<E>(std::as_const(step_.data));
    }
    /// The same, to remove and to change them.
    template <class E> auto& edit() {
        edited<E>();
        static_assert(Y::phase >= phases::breaking && Y::phase < phases::sums,
                      "Ansatz: a system changes elements of another policy where others walk over them; let its phase "
                      "be one from phases::breaking on and before phases::sums");
        detail::elements_will_change(step_);
        return detail::elements_in<E>(step_.data);
    }
    /// Divides a body at its place, within a step: a new one takes a share of its mass and of the forces on it, and has
    /// all else of it: a shape, contacts, and behind the step a copy of your Datum. At a phase as for `edit`. So that
    /// there is room for it, what the policy keeps says beforehand how many may come, `std::size_t bodies_to_come(const
    /// Policy&) const`.
    /// \param share of the mass, between 0 and 1; of nothing where it is infinite
    /// \return the id of the new one
    std::uint32_t divide(std::uint32_t id, typename S::Scalar share) {
        static_assert(Y::phase >= phases::breaking && Y::phase < phases::sums,
                      "Ansatz: a system divides bodies in the midst of others' loops; let its phase be one from "
                      "phases::breaking on and before phases::sums");
        static_assert(detail::copies_datum<typename C::policies>,
                      "Ansatz: a policy of this world divides bodies, and the Datum<T> of the new one is a copy, which "
                      "this T does not allow; take a T that can be copied, or keep it beside the world, by handle");
        return detail::divide_body(step_, id, share);
    }
    /// @}

private:
    template <class E> static constexpr void edited() {
        static_assert(
            detail::stands_in<E, detail::edits_of<Y>>,
            "Ansatz: a system changes elements without saying so; add them to its `using edits = Types<...>;`");
    }
    template <class Column, class List> static constexpr void declared() {
        static_assert(detail::contains<Column, List>,
                      "Ansatz: a system touches a column that it did not declare; add it to its `reads` or, to change "
                      "it, to its `writes`, e.g. `using writes = Columns<Velocity>;`");
    }
    StepT& step_;
};

namespace detail {

template <class P, class S> struct SystemsOfPolicy {
    using type = Types<>;
};
template <class P, class S>
    requires requires { typename P::template systems<S>; }
struct SystemsOfPolicy<P, S> {
    using type = typename P::template systems<S>;
};
template <class List> struct NeedsOfSystems;
template <class... Y> struct NeedsOfSystems<Types<Y...>> {
    using type = union_of<Columns<>, writes_of<Y>..., reads_of<Y>...>;
};
/// The columns that the systems of a policy touch.
template <class P, class S>
using needs_of_systems = typename NeedsOfSystems<typename SystemsOfPolicy<P, S>::type>::type;

/// A row system as an effect: what `Effects` binds.
template <class P, class Y> struct AsEffect : P {
    using writes = writes_of<Y>;
    using reads = reads_of<Y>;
    template <class> struct In : Y {
        explicit In(const AsEffect& policy) : Y(static_cast<const P&>(policy)) {}
    };
};

/// A substep, as a driver asks for it.
template <class StepT, class Inside> class PartOfStep {
public:
    using Time = typename StepT::S::Time; ///< s

    PartOfStep(StepT& step, const Inside& inside)
        : step_(step), inside_(inside), whole_(step.context), previous_(step.context.dt().previous) {}
    ~PartOfStep() { step_.context = whole_; }
    PartOfStep(const PartOfStep&) = delete;
    PartOfStep& operator=(const PartOfStep&) = delete;

    /// A substep, and not the last.
    void operator()(const Time& h) {
        begin(h);
        auto part = step_.template as<Columns<>, StepT::later>();
        inside_(part);
    }
    /// The last one: what acts for one step only is gone behind it.
    void last(const Time& h) {
        begin(h);
        inside_(step_);
    }

private:
    void begin(const Time& h) {
        using Clock_ = typename StepT::S::ClockTime;
        step_.context =
            Context<typename StepT::S>(Clock_(whole_.time() + done_), TimeStep<typename StepT::S>(h, previous_));
        step_.bound.prepare(step_.context);
        done_ += Clock_::from_value(typename StepT::S::ClockScalar(h.value()));
        previous_ = h;
    }

    StepT& step_;
    const Inside& inside_;
    Context<typename StepT::S> whole_;
    Time previous_;
    typename StepT::S::ClockTime done_{};
};

/// A system that names this verb is none of rows: of another signature it would be asked for `apply`.
struct RunVerb {
    int run;
};
template <class Y>
struct BesideRunVerb
    : Y
    , RunVerb {};
template <class Y> inline constexpr bool names_run = false;
template <class Y>
    requires(!std::is_final_v<Y>)
inline constexpr bool names_run<Y> = !requires { &BesideRunVerb<Y>::run; };

/// A system of a policy in the schedule.
template <class P, class Y> struct PolicySystem {
    static constexpr Phase phase = Y::phase;
    static constexpr std::string_view name = Y::name;
    template <class StepT> static void run(StepT& step) {
        const P& policy = std::get<P>(step.policies);
        if constexpr (
            requires { &Y::run; } || requires(Y& y, SystemView<StepT, P, Y>& view) { y.run(view, step.context); }) {
            SystemView<StepT, P, Y> view(step);
            Y(policy).run(view, step.context);
        } else if constexpr (names_run<Y>) {
            static_assert(!names_run<Y>, "Ansatz: a table system with a wrong signature; it needs "
                                         "`void run(auto& view, const auto& context) const`");
        } else MotionStep(step).template row_system<AsEffect<P, Y>>(AsEffect<P, Y>{policy});
    }
};
/// A driver of a policy in the schedule.
template <class P, class Y>
    requires requires { Y::until; }
struct PolicySystem<P, Y> {
    static constexpr Phase phase = Y::phase, until = Y::until;
    static constexpr std::string_view name = Y::name;
    template <class StepT, class Inside> static void run(StepT& step, const Inside& inside) {
        SystemView<StepT, P, Y> view(step);
        const auto dt = step.context.dt();
        PartOfStep<StepT, Inside> part(step, inside);
        Y(std::get<P>(step.policies)).run(view, dt, part);
    }
};

template <class P, class List> struct Adapted;
template <class P, class... Y> struct Adapted<P, Types<Y...>> {
    using type = Types<PolicySystem<P, Y>...>;
};
template <class S, class List> struct AllPolicySystems;
template <class S, class... P> struct AllPolicySystems<S, Types<P...>> {
    using type = joined_types<typename Adapted<P, typename SystemsOfPolicy<P, S>::type>::type...>;
};
/// The systems of the policies of a world.
template <class C> using systems_of_policies = typename AllPolicySystems<typename C::S, typename C::policies>::type;

} // namespace detail
} // namespace ansatz
