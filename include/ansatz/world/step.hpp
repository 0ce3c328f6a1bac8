// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The step: a world's systems, run in the order of its schedule, and nothing else.
///
/// Here is what every system works on, and the two systems that belong to the frame: time goes on, and observers see
/// what was made. All others are those of modules and policies; `print_schedule(world)` shows them in their order. The
/// step does not allocate, throw or print once the world is warm.

#include <ansatz/world/inside.hpp>
#include <ansatz/world/schedule.hpp>
#include <ansatz/world/view.hpp>

#include <ostream>
#include <tuple>
#include <utility>

namespace ansatz {

/// One step of a world, or a substep, as its systems see it.
/// \tparam TransientT the columns that are set back to zero behind it: none where it is a substep and not the last
/// \tparam Later      whether it is a substep and not the first
template <class C, class Policies, class TransientT = typename C::transient, bool Later = false> struct Step {
    using Composition_ = C;              ///< of the world
    using S = typename C::S;             ///< the space
    using Data = WorldData<C>;           ///< what the step works on
    using Policies_ = Policies;          ///< of the world
    using Slot = typename Data::Slot;    ///< a body's place in the lanes
    using Transient = TransientT;        ///< set back to zero behind it
    static constexpr bool later = Later; ///< a substep and not the first

    Data& data;                  ///< the world
    Policies& policies;          ///< its policies
    BoundPolicies<C>& bound;     ///< prepared for this substep
    Context<S>& context;         ///< when it begins, and how long it is
    typename S::ClockTime whole; ///< how long the step is that is taken, in the digits of the clock

    /// The same, as another substep of it.
    template <class Columns_, bool Later_> Step<C, Policies, Columns_, Later_> as() const {
        return {data, policies, bound, context, whole};
    }
    /// What policy `P` may see.
    template <class P> ObserverView<S, P> view_of() const { return ObserverView<S, P>(std::as_const(data)); }
    /// Behind this step: the next one, if it has the same length.
    Context<S> after() const {
        const typename S::Time last = data.last_part_of(context.dt());
        return Context<S>(data.clock.now(), TimeStep<S>(last, last));
    }
    /// Tells the modules.
    template <class Hook, class... A> void tell(A&&... argument) const {
        detail::tell<Hook>(typename C::modules{}, *this, argument...);
    }
};

namespace detail {

/// Time goes on.
struct Tick {
    static constexpr Phase phase = phases::clock;
    static constexpr std::string_view name = "clock";
    static void run(auto& step) { step.data.clock.advance(step.whole); }
};
/// Observers see what was made.
struct Observe {
    static constexpr Phase phase = phases::observers;
    static constexpr std::string_view name = "observers";
    template <class StepT> static void run(StepT& step) {
        [&]<class... O>(Types<O...>) { (one<O>(step), ...); }(typename StepT::Composition_::observers{});
    }

private:
    template <class O> static void one(auto& step) {
        const auto view = step.template view_of<O>();
        if constexpr (requires { std::get<O>(step.policies).observe(view); }) std::get<O>(step.policies).observe(view);
    }
};

template <class C, class... M> auto systems_of_modules(Types<M...>) -> joined_types<typename SystemsIn<M, C>::type...>;
/// All systems of a world, in order.
template <class C>
using ScheduleOf = InOrder<joined_types<decltype(systems_of_modules<C>(typename C::modules{})), Types<Tick>,
                                        std::conditional_t<(C::observers::size > 0), Types<Observe>, Types<>>>>;

} // namespace detail

/// Takes a step, or a substep.
/// \param dt its length
template <class Transient, bool Later, class C, class Policies>
void take_step(WorldData<C>& data, Policies& policies, const BoundPolicies<C>& bound, const TimeStep<typename C::S>& dt,
               const typename C::S::ClockTime& whole) {
    using Schedule = detail::ScheduleOf<C>;
    static_assert(!Schedule::ambiguous, "Ansatz: two systems of one name stand at one phase of the step, so that which "
                                        "comes first would depend on the order of the policies; give one of them "
                                        "another name, or a phase of its own");
    auto prepared = bound;
    Context<typename C::S> context(data.clock.now(), dt);
    prepared.prepare(context);
    Step<C, Policies, Transient, Later> step{data, policies, prepared, context, whole};
    detail::run_systems<Schedule, 0, Schedule::size>(step);
}

/// Prints what a step of this world does, in its order: a line for each system, those that a driver owns set in.
template <class World_> void print_schedule(const World_&, std::ostream& out) {
    using Schedule = detail::ScheduleOf<typename World_::composition>;
    [&]<int... K>(std::integer_sequence<int, K...>) {
        double until = -1;
        auto line = [&]<int N>() {
            using Y = typename Schedule::template at<N>::type;
            out << (Y::phase.at < until ? "    " : "") << Y::name << '\n';
            if constexpr (detail::is_driver<Y>) until = Y::until.at;
        };
        (line.template operator()<K>(), ...);
    }(std::make_integer_sequence<int, Schedule::size>{});
}

} // namespace ansatz
