// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What a body's acceleration and velocity are at the present time, what keeps the velocity when the forces change, and
/// what wakes. Where the integrator stores a velocity, most of this is nothing. Where it keeps the history of positions
/// (Verlet), the velocity is the mean of the last step and half a step of the present acceleration, so that whatever
/// changes a force would change the velocity as well, were it not held here.

#include <ansatz/motion/coupling.hpp>
#include <ansatz/motion/sleep.hpp>
#include <ansatz/motion/step.hpp>

namespace ansatz::detail {

/// The data in which the forces between bodies are those of the present: a copy where they are not known, because the
/// sums belong to all bodies at once, and a query changes nothing. There is one copy for each change, however many ask.
template <class I> const auto& at_present(const I& inside) {
    if constexpr (I::Composition_::coupled)
        if (!inside.data.coupled.current)
            return inside.data.present.get([&] {
                auto present = inside.data;
                refresh_coupled(present, inside.policies, inside.context());
                return present;
            });
    return std::as_const(inside.data);
}

/// The acceleration of a body whose velocity stands in the row.
template <class C, class I>
typename C::S::Acceleration acceleration_of(const I& inside, const WorldData<C>& data, std::uint32_t slot,
                                            const typename WorldData<C>::Body& row) {
    if (data.bodies.motion(slot) == Motion::moving || data.bodies.motion(slot) == Motion::fixed)
        return typename C::S::Acceleration();
    typename C::S::Acceleration a = inside.bound.laws.acceleration(row, inside.context());
    if constexpr (C::coupled)
        a += data.lanes.template get<InverseMass>(slot) * data.lanes.template get<CoupledForce>(slot);
    return a;
}

/// The velocity of a body, the sums of the forces between bodies being those of `data`.
template <class C, class I>
typename C::S::Velocity velocity_in(const I& inside, const WorldData<C>& data, std::uint32_t slot) {
    auto row = data.load(slot);
    if constexpr (C::history)
        if (!data.waiting(slot) && data.bodies.motion(slot) == Motion::awake &&
            data.last_dt().value() > typename C::S::Scalar(0)) {
            auto& v = row.template get<Velocity>();
            const typename C::S::Velocity mean = v;
            v = C::Integrator::velocity_now(mean, acceleration_of(inside, data, slot, row), data.last_dt());
            // A force of velocity was asked at the velocity of half a step ago: an error of first order in what it
            // says, and, where velocities are read and given back in every step, in the motion.
            if constexpr (C::velocity_read)
                v = C::Integrator::velocity_now(mean, acceleration_of(inside, data, slot, row), data.last_dt());
        }
    return row.template get<Velocity>();
}

/// What all forces together do to a body now.
template <class I> auto acceleration_at(const I& inside, std::uint32_t slot) {
    const auto& data = at_present(inside);
    auto row = data.load(slot);
    row.template get<Velocity>() = velocity_in(inside, data, slot);
    return acceleration_of(inside, data, slot, row);
}

/// Whether what is known suffices to tell a body's velocity. A change that waits to be made good changes none: the
/// velocity is what the forces before it made it, and their sums stand in the column until then.
template <class I> bool knows_velocity(const I& inside, std::uint32_t slot) {
    using C = typename I::Composition_;
    if constexpr (C::history && C::coupled) {
        const auto& data = inside.data;
        return data.coupled.current || data.coupled.changed || data.waiting(slot) ||
               data.bodies.motion(slot) != Motion::awake || !(data.last_dt().value() > typename C::S::Scalar(0));
    } else return true;
}

/// The velocity of a body now.
template <class I> auto velocity_at(const I& inside, std::uint32_t slot) {
    using C = typename I::Composition_;
    if constexpr (C::history)
        if (inside.data.waiting(slot)) return inside.data.raw_velocity(slot);
    const bool known = knows_velocity(inside, slot);
    return velocity_in(inside, known ? std::as_const(inside.data) : at_present(inside), slot);
}

/// For verbs: the sums in place, so that asking for a velocity needs no copy.
template <class I> void settle(const I& inside) {
    using C = typename I::Composition_;
    if constexpr (C::history && C::coupled) refresh_coupled(inside.data, inside.policies, inside.context());
}

/// The same, if a body's velocity cannot be told without.
template <class I> void settle_for(const I& inside, std::uint32_t slot) {
    if (!knows_velocity(inside, slot)) settle(inside);
}

/// Before something changes what the laws do to one body: where velocity is derived from history with half a step of
/// the present acceleration, it is now what the old laws made it.
template <class I> void hold_velocity(const I& inside, [[maybe_unused]] std::uint32_t slot) {
    if constexpr (I::Composition_::history)
        if (inside.data.bodies.motion(slot) == Motion::awake) {
            settle_for(inside, slot);
            inside.data.set_velocity(slot, velocity_at(inside, slot));
        }
}
/// The same for all bodies.
template <class I> void hold_velocities(const I& inside) {
    if constexpr (I::Composition_::history) {
        for (std::size_t slot = 0; slot < inside.data.bodies.end(Motion::awake); ++slot)
            hold_velocity(inside, std::uint32_t(slot));
    }
}

/// Before something changes what the forces between bodies see. Their sums are stale then; and where velocity is
/// derived from history, the change is made good when they are summed anew.
template <class I> void forces_change(const I& inside) {
    using C = typename I::Composition_;
    if constexpr (C::coupled) {
        if constexpr (C::history)
            if (inside.data.clock.tick() > 0 && !inside.data.coupled.changed) {
                settle(inside);
                inside.data.coupled.changed = true;
            }
        inside.data.coupled.current = false;
        inside.data.present.forget();
    }
}

/// Wakes a resting body; another has its time of rest begin anew.
template <class I> void wake_slot(const I& inside, std::uint32_t slot) {
    using C = typename I::Composition_;
    if constexpr (C::rests) {
        auto& data = inside.data;
        data.lanes.template set<RestTime>(slot, typename C::S::Time());
        if (data.bodies.motion(slot) != Motion::resting) return;
        data.events.between_steps({Event::Kind::woke, data.bodies.handle(slot)});
        if (!data.waiting(slot)) data.begin_again(slot);
        data.move(slot, Motion::awake);
    }
}
/// Wakes everybody.
template <class I> void wake_all(const I& inside) {
    if constexpr (I::Composition_::rests)
        for (std::uint32_t id = 0; id < inside.data.bodies.ids(); ++id)
            if (inside.data.bodies.alive(id)) wake_slot(inside, inside.data.bodies.slot_of_id(id));
}
/// Wakes the neighbours of a body: those that touch it, and those that hang together with it.
template <class I> void wake_around(const I& inside, [[maybe_unused]] std::uint32_t id) {
    using C = typename I::Composition_;
    if constexpr (C::rests) {
        auto& data = inside.data;
        const auto wake = [&](std::uint32_t other) { wake_slot(inside, data.bodies.slot_of_id(other)); };
        data.template ask<hook::EachNeighbour>(id, wake);
        if constexpr (C::islands)
            if (data.bodies.count(Motion::resting) > 0)
                for_each_element_of(
                    data, id, [&](const auto& state, std::uint32_t element) { state.for_each_body(element, wake); });
    }
}

} // namespace ansatz::detail
