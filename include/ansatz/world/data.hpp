// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `WorldData`: what a world holds of its bodies, and how one body is read from it and written to it.
///
/// This is the value that is copied, hashed and saved. It has no policy in it and no algorithm: the step is in
/// step.hpp, the door with its checks in world.hpp.

#include <ansatz/world/bodies.hpp>
#include <ansatz/world/cache.hpp>
#include <ansatz/world/clock.hpp>
#include <ansatz/world/composition.hpp>
#include <ansatz/world/context.hpp>
#include <ansatz/world/events.hpp>
#include <ansatz/world/islands.hpp>
#include <ansatz/world/lanes.hpp>

#include <cstdint>
#include <vector>

namespace ansatz {

/// What could go wrong inside a step and does not stop it; poll it with World::status.
struct Status {
    bool lost =
        false; ///< a step was broken off by an exception: the world is half of it, and takes nothing but another world
    std::uint64_t unsolved = 0;   ///< body steps whose equation an implicit integrator could not solve, so far
    std::uint64_t not_finite = 0; ///< bodies whose state is infinite or not a number, now
    Handle first_not_finite{};    ///< the one with the smallest id among them
    /// Nothing went wrong.
    bool ok() const { return !lost && unsolved == 0 && not_finite == 0; }
};

namespace detail {
/// Bodies that wait for the start of their history. Verlet's first step needs dt and the acceleration, which are only
/// known when the step is taken (notes 1.6.4). Until then the body's history lane holds its *velocity*.
struct Starts {
    enum State : std::uint8_t { begun, waits, forgotten };
    std::vector<std::uint8_t> state; // State by id; of bytes, since every program compiles those anyway
    std::vector<std::uint32_t> list; // ids that wait or are forgotten, each once

    [[gnu::cold]] void reserve(std::size_t n) {
        state.reserve(n);
        list.reserve(n);
    }
    void make_room_for(const Starts& other) {
        state.reserve(other.state.size());
        list.reserve(other.list.size());
    }
    bool waiting(std::uint32_t id) const { return id < state.size() && state[id] == waits; }
    void wait(std::uint32_t id) {
        if (state.size() <= id) state.resize(id + 1, begun);
        if (state[id] == begun) list.push_back(id);
        state[id] = waits;
    }
    /// It stays in the list until the next step: to look for it there would take a time that grows with the list.
    void forget(std::uint32_t id) {
        if (waiting(id)) state[id] = forgotten;
    }
};

/// Whether the column CoupledForce holds the forces between bodies of the present state, as a step of these lengths
/// asks for them. A cache: neither hashed nor saved, and a step comes to the same bits without it.
template <class S> struct CoupledSums {
    bool current = false;
    bool changed = false; ///< a change through the door waits to be made good; the column holds what was before it
    std::vector<typename S::Scalar> before{};
    std::vector<typename S::Scalar> platforms{}; ///< where they were when the step began
    typename S::Time dt{}, previous{};

    bool known_for(const TimeStep<S>& step) const {
        return current && dt.value() == step.value() && previous.value() == step.previous.value();
    }
    void make_room_for(const CoupledSums& other) {
        before.reserve(other.before.size());
        platforms.reserve(other.platforms.size());
    }
    void know(const TimeStep<S>& step) {
        current = true;
        dt = step;
        previous = step.previous;
    }
};
/// What the policies of a world keep beside the bodies.
template <class S, class List> struct States;
template <class S, class... P> struct States<S, Types<P...>> {
    std::tuple<state_of<P, S>...> each;
    std::uint64_t layout = 0; ///< counts the exchanges of slots, so that a state may remember where bodies are

    template <class F> void for_each(F&& f) {
        std::apply([&](auto&... state) { (f(state), ...); }, each);
    }
    template <class F> void for_each(F&& f) const {
        std::apply([&](const auto&... state) { (f(state), ...); }, each);
    }
};
template <class S> struct States<S, Types<>> {
    static void for_each(auto&&) {}
};
inline constexpr Absent absent{};

/// Whether assigning what a policy keeps cannot fail once there is room: it says so, or owns nothing, for what owns
/// memory has a destructor.
template <class T> inline constexpr bool makes_room = requires(T& to, const T& from) { to.make_room_for(from); };
template <class List> inline constexpr bool all_make_room = true;
template <class... T>
inline constexpr bool all_make_room<std::tuple<T...>> = ((makes_room<T> || std::is_trivially_destructible_v<T>)&&...);
template <class S, class List> inline constexpr bool states_make_room = true;
template <class S, class... P>
inline constexpr bool states_make_room<S, Types<P...>> = all_make_room<std::tuple<state_of<P, S>...>>;
template <class T> constexpr bool assigns_in_place() {
    if constexpr (requires { T::assigns_in_place; }) return T::assigns_in_place;
    return true;
}
template <class T> void make_room_for(T& to, const T& from) {
    if constexpr (makes_room<T>) to.make_room_for(from);
}

template <class List> struct ControlOf { // nothing decides, or something that is refused with a sentence
    using type = Cache<Absent>;
};
template <class First, class... Rest>
    requires requires { typename First::Kept; }
struct ControlOf<Types<First, Rest...>> {
    using type = Cache<typename First::Kept>;
};
template <class C, bool Together> struct TogetherOf {
    using type = Absent;
};
template <class C, bool Collides> struct CollisionsOf {
    using type = Absent;
};
template <class C> struct CollisionsOf<C, true> {
    using type = typename C::Narrowphase::template Collisions<C>;
};
template <class C> struct TogetherOf<C, true> {
    using type = Cache<typename C::Integrator::template Together<typename C::S>>;
};
} // namespace detail

/// All that a world of this composition holds.
template <class C> struct WorldData {
    /// The space.
    using S = typename C::S;
    using Integrator = typename C::Integrator; ///< the integrator
    using Scalar = typename S::Scalar;
    using Slot = Bodies::Slot; ///< a body's place in the lanes

    /// Every column of a body that some policy may look at, Velocity included where it is derived.
    using AllColumns = union_of<typename C::needed, Columns<Position, Velocity>>;
    using Body = Row<S, AllColumns>; ///< one body's values

    Lanes<S, typename C::stored> lanes; ///< the columns
    Bodies bodies;                      ///< who is where
    StepClock<S> clock;                 ///< tick and time
    /// What waits for the next step, because dt or the acceleration is not known before.
    [[no_unique_address]] std::conditional_t<C::history, detail::Starts, detail::Absent> starts;
    /// Who fell asleep and woke in the last step.
    [[no_unique_address]] std::conditional_t<C::rests, Events, detail::Absent> events;
    /// Whether the sums of the forces between bodies are those of the present state.
    [[no_unique_address]] std::conditional_t<C::coupled, detail::CoupledSums<S>, detail::Absent> coupled;
    /// What policies keep beside the bodies, such as springs.
    [[no_unique_address]] detail::States<S, typename C::keepers> states;
    /// The shapes of bodies, and their contacts.
    [[no_unique_address]] typename detail::CollisionsOf<C, C::collides>::type collisions;
    /// What an integrator keeps that advances all bodies together: vectors, a matrix.
    [[no_unique_address]] typename detail::TogetherOf<C, C::together>::type together;
    /// Room for finding out who falls asleep.
    [[no_unique_address]] std::conditional_t<C::islands, detail::Cache<SleepScratch<S>>, detail::Absent> sleep;
    /// What decides how a step is taken keeps its numbers here.
    [[no_unique_address]] typename detail::ControlOf<typename C::controls>::type control;
    std::uint64_t unsolved = 0; ///< bodies whose implicit step did not converge; where bodies are coupled, such steps

    /// What policy `P` keeps; nothing, where it keeps nothing.
    template <class P> const auto& state() const {
        if constexpr (detail::keeps_state<P, S>) return std::get<detail::place_of<P, typename C::keepers>>(states.each);
        else return detail::absent;
    }
    /// The same, to change it.
    template <class P>
    auto& state()
        requires detail::keeps_state<P, S>
    {
        return std::get<detail::place_of<P, typename C::keepers>>(states.each);
    }

    /// Room for so many bodies in everything.
    [[gnu::cold]] void reserve(std::size_t n) {
        lanes.reserve(n);
        bodies.reserve(n);
        if constexpr (C::collides) collisions.reserve(n);
        reserve_notes(n);
    }
    /// Whether a copy can be assigned in the room that is there: nothing in it owns memory that is not asked for here.
    static constexpr bool assigns_in_place =
        std::is_trivially_destructible_v<Scalar> && detail::states_make_room<S, typename C::keepers> &&
        detail::assigns_in_place<typename detail::CollisionsOf<C, C::collides>::type>();
    /// Room for what another holds, so that assigning it cannot fail.
    void make_room_for(const WorldData& other) {
        lanes.reserve(other.lanes.size());
        bodies.make_room_for(other.bodies);
        detail::make_room_for(starts, other.starts);
        detail::make_room_for(events, other.events);
        detail::make_room_for(coupled, other.coupled);
        detail::make_room_for(collisions, other.collisions);
        [&]<class... P>(Types<P...>) {
            (detail::make_room_for(state<P>(), other.template state<P>()), ...);
        }(typename C::keepers{});
    }
    /// Room for what a step, or anything that is done to the world between steps, may note about each body. A copied
    /// vector has no more room than it needs, so the first of them makes it, and no later one.
    void reserve_notes([[maybe_unused]] std::size_t n) {
        bodies.reserve_notes();
        if constexpr (C::history) starts.reserve(n);
        if constexpr (C::rests) events.reserve(n);
        if constexpr (C::islands) sleep.value.reserve(n);
        if constexpr (C::coupled) coupled.platforms.reserve(bodies.count(Motion::moving) * std::size_t(S::dimension));
        if constexpr (C::coupled && C::history) coupled.before.reserve(n * std::size_t(S::dimension));
        states.for_each([](auto& state) { state.reserve_notes(); });
    }

    /// Room for what only a step notes, such as what breaks in it: who reads those of the last step may do what he
    /// likes meanwhile.
    void reserve_notes_of_step() {
        states.for_each([](auto& state) {
            if constexpr (requires { state.reserve_notes_of_step(); }) state.reserve_notes_of_step();
        });
    }

    /// From one range of bodies to another.
    Slot move(Slot slot, Motion to) {
        return bodies.move(slot, to, [&](std::size_t i, std::size_t j) { swap(i, j); });
    }
    /// Room for a body that is about to be added, in the notes too; `id` is the one that it gets.
    void make_room(std::uint32_t id, [[maybe_unused]] bool moves) {
        reserve_notes(std::size_t(id) + 1 > bodies.ids() ? std::size_t(id) + 1 : bodies.ids());
        if constexpr (C::collides) collisions.make_room(id);
        if constexpr (C::coupled) { // here, so that no step needs to
            const auto needed = (bodies.count(Motion::moving) + moves) * std::size_t(S::dimension);
            if (coupled.platforms.capacity() < needed) coupled.platforms.reserve(2 * needed);
        }
    }
    /// Removes a body; the others keep their order, but for one or a few.
    void erase(Slot slot) {
        if constexpr (C::history) starts.forget(bodies.id(slot));
        states.for_each([&](auto& state) { state.body_removed(bodies.id(slot)); });
        if constexpr (C::collides) collisions.body_removed(bodies.id(slot));
        bodies.erase(slot, [&](std::size_t i, std::size_t j) { swap(i, j); });
        lanes.pop_back();
    }

    /// The length of the last step; none before the first.
    typename S::Time last_dt() const {
        if constexpr (C::substeps && C::history)
            return S::Time::from_value(Scalar(clock.last().value()) / Scalar(collisions.parts)); // of the last part
        else return S::Time::from_value(Scalar(clock.last().value()));
    }

    /// Whether something waits for this body.
    bool waiting(Slot slot) const {
        if constexpr (C::history) return starts.waiting(bodies.id(slot));
        return false;
    }

    /// The values of one body. Where the velocity is derived, it is the mean over the last step.
    Body load(Slot slot) const { return load(slot, last_dt()); }
    /// The same, where the last step's length is known better: in the first step, when there is none yet.
    Body load(Slot slot, [[maybe_unused]] const typename S::Time& last) const {
        Body row;
        load_columns(row, slot, typename C::stored{}, AllColumns{});
        if constexpr (C::history) {
            if (waiting(slot)) row.template get<Velocity>() = raw_velocity(slot);
            else if (last.value() > Scalar(0)) // before the first step what does not wait stands still
                detail::derive_velocity<Integrator>(row, last);
        }
        return row;
    }

    /// The velocity that a body was given and whose history has not begun.
    typename S::Velocity raw_velocity(Slot slot) const
        requires C::history
    {
        return S::Velocity::from_value(lanes.template get<PreviousPosition>(slot).value());
    }

    /// Gives a body a velocity.
    void set_velocity(Slot slot, const typename S::Velocity& v) {
        if constexpr (C::history) {
            lanes.template set<PreviousPosition>(slot, S::Position::from_value(v.value()));
            starts.wait(bodies.id(slot));
        } else lanes.template set<Velocity>(slot, v);
    }

    /// Stops a body exactly.
    void stop(Slot slot) {
        // Drawn where it lies from now on: the step no longer looks at it, and it may wake at any time.
        if constexpr (C::template stores<DrawnPosition>)
            lanes.template set<DrawnPosition>(slot, lanes.template get<Position>(slot));
        if constexpr (C::history) {
            starts.forget(bodies.id(slot));
            lanes.template set<PreviousPosition>(slot, lanes.template get<Position>(slot));
        } else lanes.template set<Velocity>(slot, S::template zero_vector<unit::Velocity>());
    }

    /// A resting body that wakes: its history begins anew, or waking would be a push of half a step of acceleration.
    void begin_again(Slot slot) {
        if constexpr (C::history) set_velocity(slot, S::template zero_vector<unit::Velocity>());
    }

private:
    void swap(std::size_t i, std::size_t j) {
        lanes.swap(i, j);
        if constexpr (C::keepers::size > 0) ++states.layout;
    }
    template <class... Stored, class... All>
    void load_columns(Body& row, Slot slot, Columns<Stored...>, Columns<All...>) const {
        auto one = [&]<class Which>(Columns<Which>) {
            if constexpr (detail::contains<Which, Columns<Stored...>>)
                row.template get<Which>() = lanes.template get<Which>(slot);
        };
        (one(Columns<All>{}), ...);
    }
};

} // namespace ansatz
