// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Which bodies wake and which fall asleep in a step (notes 1.1, 1.8), in worlds with a policy that puts bodies to
/// rest.
///
/// A body rests when it has been slow for long enough and would stay: at velocity zero next to nothing pulls at it.
/// Where bodies touch or hang together, they do so together (sleep.hpp).

#include <ansatz/motion/forces_at_rest.hpp>
#include <ansatz/motion/sleep.hpp>
#include <ansatz/motion/step.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace ansatz {

namespace detail {
/// Whether an acceleration may remain to a body that rests.
template <class S> bool balanced(const auto& rest, const typename S::Acceleration& remains) {
    if constexpr (requires { rest.balanced(remains); }) return rest.balanced(remains);
    else return remains == S::template zero_vector<unit::Acceleration>();
}
} // namespace detail

/// Takes a resting body back into the awake range, within a step.
template <class C> Bodies::Slot wake_resting(WorldData<C>& data, Bodies::Slot slot) {
    data.events.in_step({Event::Kind::woke, data.bodies.handle(slot)});
    data.lanes.template set<RestTime>(slot, C::S::Time::from_value(typename C::S::Scalar(0)));
    data.begin_again(slot);
    return data.move(slot, Motion::awake);
}

/// Rest in a step, or in a substep.
template <class StepT> class RestStep : public MotionStep<StepT> {
    using Base = MotionStep<StepT>;
    using Base::bound_;
    using Base::context_;
    using Base::data_;
    using Base::policies_;
    using Base::step_;

public:
    using Base::Base;
    using typename Base::C;
    using typename Base::Data;
    using typename Base::S;
    using typename Base::Scalar;
    using typename Base::Slot;

    /// The policy that decides.
    using Rester = typename detail::FirstIn<typename C::resters>::type;
    /// Whether what pulls at a body depends on where it is, or on the time.
    static constexpr bool pull_varies =
        C::coupled || C::Laws::time_dependent || detail::contains<Position, typename C::Laws::needs>;

    /// Wakes resting bodies on which a force acts that did not act when they fell asleep.
    void wake_pulled() {
        auto behind = Slot(data_.bodies.end(Motion::resting)); // the first that is asked, from the last slot on
        if constexpr (keeps_still) {
            auto& still = data_.still_forces.value;
            if (still.holds(data_) && still.asked()) {
                const auto& border = still.border();
                const auto wakes = std::find_if(border.begin(), border.end(), [&](Slot slot) { return !stays(slot); });
                if (wakes == border.end()) return;
                behind = *wakes + 1;
            }
        }
        const auto woken = data_.bodies.woken();
        for (auto slot = behind; slot-- > data_.bodies.begin(Motion::resting);) {
            if (stays(slot)) continue;
            wake_resting(data_, slot);
            // The body that took this slot was at the beginning of the range: visit it too, unless it is the one
            // woken.
            if (slot >= data_.bodies.begin(Motion::resting) && slot < data_.bodies.end(Motion::resting)) ++slot;
        }
        if constexpr (keeps_still)
            if (woken == data_.bodies.woken()) data_.still_forces.value.note_asked();
    }
    /// Wakes the neighbours of bodies that were woken between two steps, before anything moves.
    void wake_neighbours() {
        const auto wake = [&](Slot slot) { wake_resting(data_, slot); };
        const auto wakes_others = [&](Slot slot) { return disturbs(data_, slot, false, context_.dt()); };
        do {
            if (data_.bodies.count(Motion::resting) == 0 || !data_.bodies.any_goes()) return;
            step_.template tell<hook::WakeTouching>();
            if constexpr (keeps_still)
                if (data_.still_forces.value.holds(data_) && !data_.still_forces.value.any_mover(wakes_others)) return;
        } while (detail::wake_through_elements(data_, wakes_others, wake));
    }
    /// A body that moves fast now begins its time of rest anew, even if the step leaves it another velocity.
    void note_speed() {
        const auto now = context_;
        context_ = Context<S>(now.time(), TimeStep<S>(S::Time::from_value(Scalar(0)), now.dt()));
        count_slow();
        context_ = now;
    }
    /// Bodies fall asleep one by one.
    void put_to_rest() {
        const detail::Bound<Rester, S> rest(std::get<Rester>(policies_));
        if constexpr (pull_varies) begin_anew(rest, [](std::size_t) { return false; });
        ask_again(
            rest, [] {}, [](std::size_t) { return false; }, [] {});
        for (auto slot = Slot(data_.bodies.end(Motion::awake)); slot-- > data_.bodies.begin(Motion::awake);)
            if (slow_long(rest)(slot) && (pull_varies || detail::balanced<S>(rest, pull_at_rest(slot, step_.after()))))
                put_to_rest(slot);
    }
    /// Islands fall asleep: those that touch each other, or hang together, do so together.
    void put_islands_to_rest() {
        if constexpr (C::rests_late) count_slow();
        const detail::Bound<Rester, S> rest(std::get<Rester>(policies_));
        auto& scratch = data_.sleep.value;
        scratch.sleepers.clear();
        if (data_.bodies.count(Motion::awake) == 0) return;
        const auto touched = [&](std::size_t slot) { return scratch.held[slot] != 0; };
        const auto mark = [&] {
            scratch.forget_held(data_.bodies.size(), data_.bodies.end(Motion::awake));
            data_.template tell<hook::MarkHeld>(scratch);
        };
        if constexpr (pull_varies || C::held_couplings::size > 0) mark();
        if constexpr (pull_varies) begin_anew(rest, touched);
        keep_awake(slow_long(rest), touched, typename C::held_couplings{});
        const auto find = [&] {
            find_sleepers(
                data_, scratch, slow_long(rest), [&](Slot slot) { return pull_at_rest(slot, step_.after()); },
                [&](const auto& add) { step_.template tell<hook::EachPush>(add); },
                [&](const auto& remains) { return detail::balanced<S>(rest, remains); });
        };
        find();
        if (scratch.sleepers.empty()) return;
        ask_again(rest, mark, touched, find);
        for (const auto id : scratch.sleepers) put_to_rest(data_.bodies.slot_of_id(id));
        refresh_forces();
        for (const auto id : scratch.sleepers) {
            const auto pull = [&] { return pull_at_rest(data_.bodies.slot_of_id(id), step_.after()); };
            data_.template tell<hook::Slept>(id, pull);
        }
    }

private:
    /// Whether the forces between bodies on most sleepers are known to be unchanged.
    static constexpr bool keeps_still = detail::keeps_still_forces<C>() && !C::Laws::time_dependent;

    /// For how long each has been slow; a step longer, or not at all.
    void count_slow() {
        this->effects_between(typename detail::EffectsFrom<S, typename C::resters>::type(std::get<Rester>(policies_)));
    }
    void put_to_rest(Slot slot) {
        data_.stop(slot);
        data_.events.in_step({Event::Kind::slept, data_.bodies.handle(slot)});
        data_.move(slot, Motion::resting);
        if constexpr (C::template couplings_read<Velocity>) data_.coupled.current = false;
    }
    /// A body that would fall asleep is tested once more, by what forces between bodies would do if they stood: `find`
    /// finds those anew.
    /// \param mark marks those that a contact may hold, and `touched` says whether one is marked
    void ask_again([[maybe_unused]] const auto& rest, [[maybe_unused]] const auto& mark,
                   [[maybe_unused]] const auto& touched, [[maybe_unused]] const auto& find) {
        if constexpr (C::template couplings_read<Velocity>) {
            {
                const ForcesAtRest<C> forces(data_, policies_, step_.after(), slow_long(rest));
                if (!forces.any()) return;
                mark();
                begin_anew(rest, [&](std::size_t slot) { return touched(slot) || !slow_long(rest)(slot); });
                find();
            }
            refresh_forces();
        }
    }
    void refresh_forces() {
        if constexpr (C::coupled) {
            data_.coupled.current = false;
            refresh_coupled(data_, policies_, step_.after());
        }
    }
    /// Whether the body of a slot has been slow for long enough.
    auto slow_long(const auto& rest) const {
        const auto* time = data_.lanes.template lane<RestTime>();
        return [&rest, time](std::size_t slot) { return rest.long_enough(S::Time::from_value(time[slot])); };
    }
    /// What swings is slow, and at its lowest point nothing pulls it: there its time must be balanced, too, not a
    /// moment of it.
    /// \param touched whether a contact may hold the body of a slot
    void begin_anew(const auto& rest, const auto& touched) {
        auto* time = data_.lanes.template lane<RestTime>();
        in_ranges<C>(policies_, 0, data_.bodies.end(Motion::awake), [&](std::size_t begin, std::size_t end) {
            for (std::size_t slot = begin; slot < end; ++slot)
                if (time[slot] > Scalar(0) && !touched(slot) &&
                    !detail::balanced<S>(rest, pull_at_rest(Slot(slot), step_.after())))
                    time[slot] = Scalar(0);
        });
    }
    /// A solver of positions holds bodies without a force. Its pull at a slow body is unknown, so that the body stays
    /// awake, unless contacts hold it: they balance that pull, and their push says how strong it is.
    template <class... Q>
    void keep_awake([[maybe_unused]] const auto& slow, [[maybe_unused]] const auto& touched, Types<Q...>) {
        if constexpr (sizeof...(Q) > 0) {
            bool any = false;
            for (std::size_t slot = 0; slot < data_.bodies.end(Motion::awake) && !any; ++slot) any = slow(slot);
            if (!any) return;
            auto* time = data_.lanes.template lane<RestTime>();
            const auto keep = [&](std::uint32_t body) {
                const auto slot = data_.bodies.slot_of_id(body);
                if (slot < data_.bodies.end(Motion::awake) && !touched(slot)) time[slot] = Scalar(0);
            };
            detail::for_each_element(data_, [&](const auto& state, std::uint32_t id) {
                constexpr bool is_held =
                    (std::is_same_v<std::remove_cvref_t<decltype(state)>, detail::state_of<Q, S>> || ...);
                if constexpr (is_held) state.for_each_body(id, keep);
            });
        }
    }
    typename S::Acceleration pull_at_rest(Slot slot, const Context<S>& context) const {
        auto row = data_.load(slot);
        row.template get<Velocity>() = S::template zero_vector<unit::Velocity>();
        return this->acceleration_at(slot, row, context);
    }
    /// Whether what pulls at a resting body leaves it where it is: it is next to nothing, or what its contacts held
    /// when it fell asleep.
    bool stays(Slot slot) {
        const auto pull = pull_at_rest(slot, context_);
        bool held = false;
        data_.template ask<hook::WasHeld>(data_.bodies.id(slot), pull, held);
        return held || detail::balanced<S>(detail::Bound<Rester, S>(std::get<Rester>(policies_)), pull);
    }
};

template <class StepT> RestStep(StepT&) -> RestStep<StepT>; ///< of a step

/// Wakes the resting bodies that a force pulls at; asked for by the first stage of a world whose bodies are coupled.
template <class StepT> void wake_pulled(MotionStep<StepT>& motion) { RestStep<StepT>(motion.step()).wake_pulled(); }

} // namespace ansatz
