// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `modules::Motion`: what a world has because its bodies move. It comes with the roles Integrator, Force and Effect,
/// and its members of `World` are those of `MotionDoor`.

#include <ansatz/motion/check.hpp>
#include <ansatz/motion/door.hpp>
#include <ansatz/motion/policy_systems.hpp>
#include <ansatz/motion/rest_step.hpp>
#include <ansatz/motion/smallest_step.hpp>
#include <ansatz/motion/step.hpp>
#include <ansatz/world/fields.hpp>

#include <string_view>

namespace ansatz {

namespace detail {

/// Wakes resting bodies on which a force acts that changes with time. Where bodies act on each other, what sums their
/// forces asks instead: the first stage, or a driver of substeps in each of them.
struct WakePulled {
    static constexpr Phase phase = phases::wake;
    static constexpr std::string_view name = "wake: bodies that are pulled at";
    static void run(auto& step) { RestStep(step).wake_pulled(); }
};
/// Wakes the neighbours of bodies that woke.
struct WakeNeighbours {
    static constexpr Phase phase = phases::wake;
    static constexpr std::string_view name = "wake: neighbours of bodies that woke";
    static void run(auto& step) { RestStep(step).wake_neighbours(); }
};
/// Bodies advance: effects, forces and stages are one loop wherever they can be.
struct Advance {
    static constexpr Phase phase = phases::forces;
    static constexpr std::string_view name = "forces and integration";
    static void run(auto& step) { MotionStep(step).integrate(); }
};
/// Effects of the whole step.
struct ActAtTheEnd {
    static constexpr Phase phase = phases::end;
    static constexpr std::string_view name = "effects at the end";
    static void run(auto& step) { MotionStep(step).effects_at_the_end(); }
};
/// What is too weak breaks.
struct Break {
    static constexpr Phase phase = phases::breaking;
    static constexpr std::string_view name = "breaking";
    static void run(auto& step) { MotionStep(step).let_break(); }
};
/// The forces of the state that was made: Rest reads them, queries read them, the next step begins with them.
struct SumForces {
    static constexpr Phase phase = phases::sums;
    static constexpr std::string_view name = "forces for rest, queries and the next step";
    static void run(auto& step) {
        step.data.coupled.current = false;
        refresh_coupled(step.data, step.policies, step.after());
    }
};
/// Bodies that have come to rest fall asleep.
struct PutToRest {
    static constexpr Phase phase = phases::rest;
    static constexpr std::string_view name = "rest";
    template <class StepT> static void run(StepT& step) {
        if constexpr (StepT::Composition_::islands) RestStep(step).put_islands_to_rest();
        else RestStep(step).put_to_rest();
    }
};

template <bool There, class Y> using only_if = std::conditional_t<There, Types<Y>, Types<>>;

/// A body of a file that is fixed or at rest has no velocity.
template <class C> void check_still(const WorldData<C>& data, std::uint32_t slot, const auto& file) {
    if constexpr (C::history) {
        if (!(data.lanes.template get<Position>(slot) == data.lanes.template get<PreviousPosition>(slot)))
            file.at("previous position").refuse_here("the body's position, because it stands still");
    } else {
        const auto v = data.lanes.template get<Velocity>(slot);
        if (!(v == C::S::template zero_vector<unit::Velocity>()))
            file.at("velocity").refuse_here("zeros, because the body stands still");
    }
}

/// While a change of the forces between bodies waits to be made good, the forces before it are a part of the state,
/// because the velocities still follow from them.
inline constexpr const char* forces_before = "forces before a change";
template <class Files, class C> void save_forces_before(const WorldData<C>& data, auto& list) {
    list = Files::Json::array();
    for_each_with_history(data, [&](std::size_t slot) {
        list.push_back(field_to_file<Files>(data.lanes.template get<CoupledForce>(slot)));
    });
}
template <class C> void load_forces_before(WorldData<C>& data, const auto& list) {
    if (data.clock.tick() == 0) list.refuse_here("nothing, because no step was taken");
    std::size_t count = 0;
    for_each_with_history(data, [&](std::size_t) { ++count; });
    list.size_is(count, "forces, one for each body that is awake and does not wait");
    std::size_t i = 0;
    for_each_with_history(data, [&](std::size_t slot) {
        auto force = data.lanes.template get<CoupledForce>(slot);
        field_from_file(force, list.at(i++));
        data.lanes.template set<CoupledForce>(slot, force);
    });
    data.coupled.changed = true;
}

} // namespace detail

namespace modules {

/// Bodies move.
struct Motion {
    /// \cond members: the table of world/modules.hpp says what they are
    static constexpr int layer = 0;
    template <class... P> using Facts = MotionFacts<P...>;
    template <class... P> using Counts = detail::MotionCounts<P...>;
    template <class... P> using CheckCounts = detail::CheckMotionCounts<P...>;
    template <class P, class S> using FactsOf = typename decltype(detail::check_of_motion<P, S>())::type::Facts;
    template <class P, class S> using SentencesOf = typename decltype(detail::check_of_motion<P, S>())::type::Sentences;
    template <class... P> using Together = detail::TogetherFacts<P...>;
    template <class... P> static constexpr bool read_together() { return detail::read_together_in_motion<P...>(); }
    template <class P, class S>
    using needs = union_of<decltype(detail::needs_in_motion<P, S>()), detail::needs_of_systems<P, S>>;
    using StandIn = detail::NoIntegrator;

    template <class C, class Data> using State = MotionState<C, Data>;
    template <class C> using Bound = BoundMotion<C>;
    template <class W, class C> using Door = MotionDoor<W, C>;
    template <class C>
    using systems =
        detail::joined_types<detail::only_if<C::rests && C::Laws::time_dependent && !C::coupled, detail::WakePulled>,
                             detail::only_if<C::islands, detail::WakeNeighbours>, Types<detail::Advance>,
                             detail::only_if<(C::template effects<Place::end_of_step>::size > 0), detail::ActAtTheEnd>,
                             detail::only_if<C::breaks, detail::Break>, detail::only_if<C::coupled, detail::SumForces>,
                             detail::only_if<C::rests, detail::PutToRest>, detail::systems_of_policies<C>>;

    // Room.
    template <class C> static void on(hook::ReserveNotes, WorldData<C>& data, [[maybe_unused]] std::size_t n) {
        if constexpr (WorldData<C>::takes_notes) {
            if (data.notes >= n) return;
            constexpr auto dimension = std::size_t(C::S::dimension);
            if constexpr (C::history) data.starts.reserve(n);
            if constexpr (C::rests) data.events.reserve(n);
            if constexpr (C::islands) data.sleep.value.reserve(n);
            if constexpr (C::asked != LawsAsked::here) data.own.value.reserve(n);
            if constexpr (C::coupled)
                data.coupled.platforms.reserve(data.bodies.count(ansatz::Motion::moving) * dimension);
            if constexpr (C::coupled && C::history) data.coupled.before.reserve(n * dimension);
            data.notes = n;
        }
    }
    template <class C>
    static void on(hook::MakeRoom, WorldData<C>& data, [[maybe_unused]] std::uint32_t id, [[maybe_unused]] bool moves) {
        if constexpr (C::asked != LawsAsked::here)
            if (data.own.value.lanes.room() <= id) data.own.value.reserve(2 * (std::size_t(id) + 1));
        if constexpr (C::coupled) { // here, so that no step needs to
            const auto needed = (data.bodies.count(ansatz::Motion::moving) + moves) * std::size_t(C::S::dimension);
            if (data.coupled.platforms.capacity() < needed) data.coupled.platforms.reserve(2 * needed);
        }
    }
    /// An integrator that advances all bodies together keeps rows of each, those to come included.
    static void on(hook::MakeRoomToCome, auto& data, std::size_t n) {
        if constexpr (requires { data.together.value.make_room_for_bodies(n); })
            data.together.value.make_room_for_bodies(data.bodies.ids() + n);
    }
    template <class C> static void on(hook::MakeRoomFor, WorldData<C>& data, const WorldData<C>& other) {
        detail::make_room_for(data.starts, other.starts);
        detail::make_room_for(data.events, other.events);
        detail::make_room_for(data.coupled, other.coupled);
    }

    // Bodies.
    template <class C> static void on(hook::Removed, WorldData<C>& data, std::uint32_t slot) {
        if constexpr (C::history) data.starts.forget(data.bodies.id(slot));
    }

    template <class C>
    static void on(hook::Divided, WorldData<C>& data, [[maybe_unused]] std::uint32_t id,
                   [[maybe_unused]] std::uint32_t part, const auto& /*share*/) {
        if constexpr (C::history)
            if (data.starts.waiting(id)) data.starts.wait(part);
    }
    template <class C> static void on(hook::Added, WorldData<C>& data, std::uint32_t slot, const auto& row) {
        const auto kind = data.bodies.motion(slot);
        if constexpr (C::template stores<DrawnPosition>)
            data.lanes.template set<DrawnPosition>(slot, row.template get<Position>());
        if (kind == ansatz::Motion::fixed || kind == ansatz::Motion::resting) data.stop(slot);
        else data.set_velocity(slot, row.template get<Velocity>());
    }

    // Changes from outside: motion/present.hpp.
    template <class Column, class I>
    static void on(hook::BeforeWrite<Column>, const I& inside, [[maybe_unused]] std::uint32_t slot) {
        using C = typename I::Composition_;
        // What no force reads leaves the velocity what it is, to the bit.
        if constexpr (detail::contains<Column, typename C::Laws::needs> || C::template couplings_read<Column>) {
            detail::hold_velocity(inside, slot);
            if constexpr (C::history) inside.template tell<hook::BeforeChange<Velocity>>();
        }
    }
    template <class... Column, class I> static void on(hook::BeforeChange<Column...>, const I& inside) {
        constexpr bool all = sizeof...(Column) == 0;
        if constexpr (all || (I::Composition_::template couplings_read<Column> || ...)) detail::forces_change(inside);
    }
    template <class I> static void on(hook::HoldVelocity, const I& inside, std::uint32_t slot) {
        detail::hold_velocity(inside, slot);
    }
    template <class I> static void on(hook::Disturbed, const I& inside, std::uint32_t id) {
        detail::wake_around(inside, id);
    }
    template <class I> static void on(hook::Wake, const I& inside, std::uint32_t slot) {
        detail::wake_slot(inside, slot);
    }
    template <class Policy, class I> static void on(hook::BeforeSet<Policy>, const I& inside) {
        // The velocity now is what the old forces made it; only from here on the new ones act.
        if constexpr (PlaysRole<Policy, roles::Force> || detail::IsCoupling<Policy>::value) {
            detail::hold_velocities(inside);
            if constexpr (I::Composition_::coupled) {
                inside.data.coupled.current = false;
                inside.data.present.forget();
            }
        }
    }
    template <class Policy, class I> static void on(hook::AfterSet<Policy>, const I& inside) {
        if constexpr (PlaysRole<Policy, roles::Force> || PlaysRole<Policy, roles::Effect> ||
                      PlaysRole<Policy, roles::System>)
            detail::wake_all(inside);
    }

    // A step.
    template <class I, class Given>
    static void on(hook::CheckStep, const I& inside, const typename I::S::Time& dt, const Given& given) {
        detail::refuse_short_step(inside, dt, given);
    }
    template <class C> static void on(hook::BeginStep, WorldData<C>& data) {
        if constexpr (C::rests) data.events.begin_step();
        if constexpr (C::coupled) data.present.forget();
    }

    // As a value.
    template <class C> static void on(hook::Report, const WorldData<C>& data, Status& status) {
        status.unsolved = data.unsolved;
    }
    template <class C> static void on(hook::IsFinite, const WorldData<C>& data, std::uint32_t slot, bool& finite) {
        const auto body = data.load(slot);
        [&]<class... Column>(Columns<Column...>) {
            ((finite = finite && detail::has_finite_numbers<Column, typename C::S>(body.template get<Column>())), ...);
        }(typename WorldData<C>::AllColumns{});
    }
    template <class C> static void on(hook::HashCounts, const WorldData<C>& data, auto& hash) {
        hash.add(data.unsolved);
    }
    template <class C>
    static void on(hook::Hash, [[maybe_unused]] const WorldData<C>& data, [[maybe_unused]] auto& hash) {
        if constexpr (C::history) hash.add_number(data.last_substep.value());
        if constexpr (C::history && C::coupled)
            if (data.coupled.changed) hash.add(1);
    }
    template <class C> static void on(hook::HashBody, const WorldData<C>& data, std::uint32_t slot, auto& hash) {
        hash.add(data.waiting(slot));
        if constexpr (C::history && C::coupled)
            if (data.coupled.changed && detail::has_history(data, slot))
                for (int k = 0; k < C::S::dimension; ++k)
                    hash.add_number(data.lanes.template lane<CoupledForce>(k)[slot]);
    }
    template <class C, class Files> static void on(hook::Save, const WorldData<C>& data, auto& file, const Files&) {
        file["unsolved"] = data.unsolved;
        if constexpr (C::history) file["last part"] = Files::number(data.last_substep.value());
        if constexpr (C::history && C::coupled)
            if (data.coupled.changed) detail::save_forces_before<Files>(data, file[detail::forces_before]);
    }
    template <class C> static void on(hook::SaveBody, const WorldData<C>& data, std::uint32_t slot, auto& file) {
        if constexpr (C::history) file["waiting"] = data.waiting(slot);
    }
    template <class C> static void on(hook::Load, WorldData<C>& data, const auto& file) {
        data.unsolved = file.at("unsolved").whole(std::numeric_limits<std::uint64_t>::max());
        if constexpr (C::history) {
            const auto last = file.at("last part");
            data.last_substep = C::S::Time::from_value(last.template number<typename C::S::Scalar>());
            if ((data.clock.tick() > 0) != (data.last_substep.value() > 0) || data.last_substep.value() < 0)
                last.refuse_here("the length of the last step, or of its last part: 0 before the first");
        }
        if constexpr (C::history && C::coupled)
            if (file.has(detail::forces_before)) detail::load_forces_before(data, file.at(detail::forces_before));
    }
    template <class C> static void on(hook::LoadBody, WorldData<C>& data, std::uint32_t slot, const auto& file) {
        const auto kind = data.bodies.motion(slot);
        if (kind == ansatz::Motion::resting && !C::rests)
            file.at("motion").refuse_here("another state; this world puts no bodies to rest");
        if (kind == ansatz::Motion::resting || kind == ansatz::Motion::fixed) detail::check_still(data, slot, file);
        if constexpr (C::history)
            if (file.at("waiting").yes()) data.starts.wait(data.bodies.id(slot));
    }
    /// \endcond
};

} // namespace modules
} // namespace ansatz
