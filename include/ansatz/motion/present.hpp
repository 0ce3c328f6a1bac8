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

/// The slot of a body in other data of the same bodies: those of `at_present`. They may be older than what no force
/// between bodies sees: a mass, an applied force, and which bodies are awake, with which they change places. Only sums
/// and histories are read from them.
template <class Data> std::uint32_t slot_in(const Data& other, const Data& data, std::uint32_t slot) {
    return &other == &data ? slot : other.bodies.slot_of_id(data.bodies.id(slot));
}

/// The acceleration of a body whose values, and whose velocity, stand in the row.
template <class C, class I>
typename C::S::Acceleration acceleration_of(const I& inside, const WorldData<C>& data, std::uint32_t slot,
                                            const typename WorldData<C>::Body& row) {
    if (data.bodies.motion(slot) == Motion::moving || data.bodies.motion(slot) == Motion::fixed)
        return typename C::S::Acceleration();
    typename C::S::Acceleration a = inside.bound.laws.acceleration(row, inside.context());
    if constexpr (C::coupled) a += row.template get<InverseMass>() * data.lanes.template get<CoupledForce>(slot);
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
    const auto& present = at_present(inside);
    const auto there = slot_in(present, std::as_const(inside.data), slot);
    auto row = inside.data.load(slot);
    if constexpr (I::Composition_::history)
        if (!inside.data.waiting(slot)) row.template get<Velocity>() = velocity_in(inside, present, there);
    return acceleration_of(inside, present, there, row);
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
    if (knows_velocity(inside, slot)) return velocity_in(inside, std::as_const(inside.data), slot);
    const auto& present = at_present(inside);
    return velocity_in(inside, present, slot_in(present, std::as_const(inside.data), slot));
}

/// For verbs: the sums in place, so that asking for a velocity needs no copy.
template <class I> void refresh(const I& inside) {
    using C = typename I::Composition_;
    if constexpr (C::history && C::coupled) refresh_coupled(inside.data, inside.policies, inside.context());
}

/// The same, if a body's velocity cannot be told without.
template <class I> void refresh_for(const I& inside, std::uint32_t slot) {
    if (!knows_velocity(inside, slot)) refresh(inside);
}

/// Before something changes what the laws do to one body: where velocity is derived from history with half a step of
/// the present acceleration, it is now what the old laws made it.
template <class I> void hold_velocity(const I& inside, [[maybe_unused]] std::uint32_t slot) {
    if constexpr (I::Composition_::history)
        if (inside.data.bodies.motion(slot) == Motion::awake) {
            refresh_for(inside, slot);
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
                refresh(inside);
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
/// Wakes all bodies.
template <class I> void wake_all(const I& inside) {
    if constexpr (I::Composition_::rests)
        for (std::uint32_t id = 0; id < inside.data.bodies.ids(); ++id)
            if (inside.data.bodies.alive(id)) wake_slot(inside, inside.data.bodies.slot_of_id(id));
}
/// Wakes the bodies that hang together with one where it is now.
template <class I> void wake_hanging(const I& inside, [[maybe_unused]] std::uint32_t id) {
    using C = typename I::Composition_;
    if constexpr (C::rests && C::islands) {
        auto& data = inside.data;
        if (data.bodies.count(Motion::resting) == 0) return;
        const auto wake = [&](std::uint32_t other) { wake_slot(inside, data.bodies.slot_of_id(other)); };
        for_each_element_of(data, id,
                            [&](const auto& state, std::uint32_t element) { state.for_each_body(element, wake); });
    }
}
/// Wakes the neighbours of a body: those that touch it, and those that hang together with it.
template <class I> void wake_around(const I& inside, [[maybe_unused]] std::uint32_t id) {
    if constexpr (I::Composition_::rests) {
        auto& data = inside.data;
        const auto wake = [&](std::uint32_t other) { wake_slot(inside, data.bodies.slot_of_id(other)); };
        data.template ask<hook::EachNeighbour>(id, wake);
        wake_hanging(inside, id);
    }
}

} // namespace ansatz::detail
