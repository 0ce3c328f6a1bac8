// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `MotionState`: what a world holds for the motion of its bodies beside their columns, and what velocity means there.
///
/// Where the integrator keeps velocities, a velocity is a column. Where it keeps the history of positions (Verlet), it
/// is derived from the last two, and a body that was given one waits for its history to begin. Only the functions here
/// know which of the two it is.

#include <ansatz/motion/events.hpp>
#include <ansatz/motion/facts.hpp>
#include <ansatz/motion/gathering.hpp>
#include <ansatz/motion/islands.hpp>
#include <ansatz/world/cache.hpp>
#include <ansatz/world/data.hpp>

#include <array>
#include <atomic>
#include <cstdint>
#include <vector>

namespace ansatz {

template <class C> class StillForces; // still_forces.hpp
namespace detail {
template <class C> constexpr bool keeps_still_forces();
}

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
    bool none() const { return list.empty(); }
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
    /// It stays in the list until the next step: to search for it there would take a time that grows with the list.
    void forget(std::uint32_t id) {
        if (waiting(id)) state[id] = forgotten;
    }
};

/// Whether the column CoupledForce holds the forces between bodies of the present state, as a step of these lengths
/// asks for them. A cache: neither hashed nor saved, and a step comes to the same bits without it. Only while a change
/// waits to be made good, the column is a part of the state.
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
/// A world that was changed, with the forces between its bodies summed anew: for queries, which change nothing. It is
/// made for the first that asks after a change; several threads may ask at once.
template <class Data> class Present {
public:
    Present() = default;
    Present(const Present&) noexcept {}
    Present& operator=(const Present&) noexcept {
        forget();
        return *this;
    }
    ~Present() { forget(); }
    /// Something was changed.
    void forget() {
        if (made_.load(std::memory_order_relaxed))
            delete made_.exchange(nullptr); // an exchange takes ten times as long
    }
    /// \param make a function that makes it
    template <class Make> const Data& get(const Make& make) const {
        const Data* there = made_.load();
        if (there) return *there;
        const auto* mine = new Data(make()); // <memory> would take longer to compile than this file
        if (made_.compare_exchange_strong(there, mine)) return *mine;
        delete mine;
        return *there;
    }

private:
    mutable std::atomic<const Data*> made_{nullptr};
};

/// What the laws did to each awake body in this substep, by slot. It is room, not a part of the value.
template <class S> struct OwnAccelerations {
    Lanes<S, Columns<OwnAcceleration>> lanes{};
    bool known = false; ///< for the state as it stands

    [[gnu::cold]] void reserve(std::size_t n) { lanes.reserve(n); }
};
/// Stands for a state that a world does not keep; each has a type of its own, so that it takes no space.
template <int Which> struct NotKept {};
template <class C, bool Together> struct TogetherOf {
    using type = NotKept<-1>;
};
template <class C> struct TogetherOf<C, true> {
    using type = Cache<typename C::Integrator::template Together<typename C::S>>;
};
} // namespace detail

/// \tparam C    the world's composition
/// \tparam Data all that the world holds, of which this is a base
template <class C, class Data> struct MotionState {
    using Integrator = typename C::Integrator; ///< the integrator
    /// Every column of a body that some policy may read, Velocity included where it is derived.
    using AllColumns = union_of<typename C::needed, writes_of<Integrator>, Columns<Position, Velocity>>;
    using Body = Row<typename C::S, AllColumns>; ///< one body's values

    std::uint64_t unsolved = 0; ///< bodies whose implicit step did not converge; where bodies are coupled, such steps
    /// What waits for the next step, because dt or the acceleration is not known before.
    [[no_unique_address]] std::conditional_t<C::history, detail::Starts, detail::NotKept<0>> starts;
    /// The bodies that fell asleep and woke in the last step.
    [[no_unique_address]] std::conditional_t<C::rests, Events, detail::NotKept<1>> events;
    /// Whether the sums of the forces between bodies are those of the present state.
    [[no_unique_address]] std::conditional_t<C::coupled, detail::CoupledSums<typename C::S>, detail::NotKept<2>>
        coupled;
    /// The same for queries, where they are not.
    [[no_unique_address]] std::conditional_t<C::coupled, detail::Present<Data>, detail::NotKept<6>> present;
    /// Which elements act on which share of the bodies, where an Execution runs the loops.
    [[no_unique_address]] std::conditional_t<
        C::coupled && C::executed,
        detail::Cache<std::array<detail::Gathering<typename C::S>, std::size_t(C::couplings::size)>>,
        detail::NotKept<8>>
        gathered;
    /// What an integrator keeps that advances all bodies together: vectors, a matrix.
    [[no_unique_address]] typename detail::TogetherOf<C, C::together>::type together;
    /// Room for finding the bodies that fall asleep.
    [[no_unique_address]] std::conditional_t<C::islands, detail::Cache<SleepScratch<typename C::S>>, detail::NotKept<3>>
        sleep;

    /// Whether verbs and steps note anything about bodies, so that they need room for it.
    static constexpr bool takes_notes = C::history || C::rests || C::coupled || C::asked != LawsAsked::here;
    /// For how many bodies there is room for notes; every verb makes sure that it suffices.
    [[no_unique_address]] std::conditional_t<takes_notes, detail::Room, detail::NotKept<7>> notes;
    /// The accelerations by the laws, where others beside the integrator use them.
    [[no_unique_address]] std::conditional_t<C::asked != LawsAsked::here,
                                             detail::Cache<detail::OwnAccelerations<typename C::S>>, detail::NotKept<5>>
        own;

    /// The velocities of awake bodies, axis by axis, while they are assumed to stand still (forces_at_rest.hpp).
    [[no_unique_address]] std::conditional_t<C::rests && C::template couplings_read<Velocity>,
                                             detail::Cache<std::vector<typename C::S::Scalar>>, detail::NotKept<9>>
        velocities;
    /// The forces between bodies that rest, kept from step to step (still_forces.hpp).
    [[no_unique_address]] std::conditional_t<detail::keeps_still_forces<C>(), detail::Cache<StillForces<C>>,
                                             detail::NotKept<10>>
        still_forces;

    /// The length of the last step, or of its last substep where a driver divides it: the time between a body's last
    /// two positions. Kept where velocities are derived from them.
    [[no_unique_address]] std::conditional_t<C::history, typename C::S::Time, detail::NotKept<4>> last_substep{};

    /// The length of the last step, or of its last substep; none before the first.
    typename C::S::Time last_dt() const {
        if constexpr (C::history) return last_substep;
        else return C::S::Time::from_value(static_cast<typename C::S::Scalar>(self().clock.last().value()));
    }

    /// The length from which velocities are derived behind a step: a driver may have taken it in substeps, and the last
    /// two positions are those of the last substep.
    /// \param whole the length of the step
    typename C::S::Time last_part_of([[maybe_unused]] const typename C::S::Time& whole) const {
        if constexpr (C::history) return last_substep;
        else return whole;
    }

    /// Whether something waits for this body.
    bool waiting([[maybe_unused]] std::uint32_t slot) const {
        if constexpr (C::history) return starts.waiting(self().bodies.id(slot));
        return false;
    }

    /// The values of one body. Where the velocity is derived, it is the mean over the last step.
    Body load(std::uint32_t slot) const { return load(slot, last_dt()); }
    /// The same with the length of the last step given: in the first step there is none yet.
    Body load(std::uint32_t slot, [[maybe_unused]] const typename C::S::Time& last) const {
        Body row;
        load_columns(row, slot, typename C::stored{}, AllColumns{});
        if constexpr (C::history) {
            if (waiting(slot)) row.template get<Velocity>() = raw_velocity(slot);
            else if (last.value() > typename C::S::Scalar(0)) // before the first step what does not wait stands still
                detail::derive_velocity<Integrator>(row, last);
        }
        return row;
    }

    /// The velocity that a body was given and whose history has not begun.
    typename C::S::Velocity raw_velocity(std::uint32_t slot) const
        requires C::history
    {
        return C::S::Velocity::from_value(self().lanes.template get<PreviousPosition>(slot).value());
    }

    /// Sets the velocity of a body.
    void set_velocity(std::uint32_t slot, const typename C::S::Velocity& v) {
        if constexpr (C::history) {
            self().lanes.template set<PreviousPosition>(slot, C::S::Position::from_value(v.value()));
            starts.wait(self().bodies.id(slot));
        } else self().lanes.template set<Velocity>(slot, v);
    }

    /// Stops a body exactly.
    void stop(std::uint32_t slot) {
        auto& lanes = self().lanes;
        // Drawn where it lies from now on: the step no longer visits it, and it may wake at any time.
        if constexpr (C::template stores<DrawnPosition>)
            lanes.template set<DrawnPosition>(slot, lanes.template get<Position>(slot));
        if constexpr (C::history) {
            starts.forget(self().bodies.id(slot));
            lanes.template set<PreviousPosition>(slot, lanes.template get<Position>(slot));
        } else lanes.template set<Velocity>(slot, C::S::template zero_vector<unit::Velocity>());
    }

    /// A resting body that wakes: its history begins anew, or waking would be a push of half a step of acceleration.
    void begin_again([[maybe_unused]] std::uint32_t slot) {
        if constexpr (C::history) set_velocity(slot, C::S::template zero_vector<unit::Velocity>());
    }

    /// Puts a body exactly there. Its history, where the integrator keeps one, is the caller's.
    void put(std::uint32_t slot, const typename C::S::Position& where) {
        self().lanes.template set<Position>(slot, where);
        if constexpr (C::template stores<PositionRemainder>)
            self().lanes.template set<PositionRemainder>(slot, C::S::template zero_vector<unit::Length>());
    }

    /// Moves a body with the history that says how fast it moves: the push is no velocity. Where a remainder is kept,
    /// pushes that are too small for the position add up in it, and the next step moves the body by them.
    void displace(std::uint32_t slot, const typename C::S::Position& by) {
        auto& lanes = self().lanes;
        const typename C::S::Position x = lanes.template get<Position>(slot), there = x + by;
        lanes.template set<Position>(slot, there);
        if constexpr (C::template stores<PositionRemainder>)
            lanes.template set<PositionRemainder>(slot, lanes.template get<PositionRemainder>(slot) +
                                                            detail::dropped_from_sum(x, by, there));
        if constexpr (C::history)
            if (!waiting(slot))
                lanes.template set<PreviousPosition>(slot, lanes.template get<PreviousPosition>(slot) + by);
    }

private:
    Data& self() { return static_cast<Data&>(*this); }
    const Data& self() const { return static_cast<const Data&>(*this); }

    template <class... Stored, class... All>
    void load_columns(Body& row, std::uint32_t slot, Columns<Stored...>, Columns<All...>) const {
        auto one = [&]<class Which>(Columns<Which>) {
            if constexpr (detail::contains<Which, Columns<Stored...>>)
                row.template get<Which>() = self().lanes.template get<Which>(slot);
        };
        (one(Columns<All>{}), ...);
    }
};

} // namespace ansatz
