// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What a body's acceleration and velocity are at the present time, what keeps the velocity when the forces change, and
/// whether something went wrong: members of `World`. Where the integrator stores a velocity, most of this is nothing.
/// Where it keeps the history of positions (Verlet), the velocity is the mean of the last step and half a step of the
/// present acceleration, so that whatever changes a force would change the velocity as well, were it not held here.
/// Included by world.hpp.
// not in the umbrella: it is a part of world.hpp, which includes it

#include <ansatz/world/coupling.hpp>
#include <ansatz/world/world.hpp>

namespace ansatz {

/// Calls `f` with the data in which the forces between bodies are those of the present: a copy where they are not
/// known, because the sums belong to all bodies at once, and a query changes nothing.
template <class... P> template <class F> auto World<P...>::at_present(F&& f) const {
    if constexpr (composition::coupled)
        if (!data_.coupled.current) {
            Data present = data_;
            refresh_coupled(present, policies_, context());
            return f(present);
        }
    return f(data_);
}

/// The acceleration of a body whose velocity stands in the row.
template <class... P>
typename World<P...>::Acceleration World<P...>::acceleration_of(const Data& data, Slot slot,
                                                                const typename Data::Body& row) const {
    if (data.bodies.motion(slot) == Motion::moving || data.bodies.motion(slot) == Motion::fixed) return Acceleration();
    Acceleration a = bound_.laws.acceleration(row, context());
    if constexpr (composition::coupled)
        a += data.lanes.template get<ansatz::InverseMass>(slot) * data.lanes.template get<CoupledForce>(slot);
    return a;
}

template <class... P> typename World<P...>::Acceleration World<P...>::acceleration_at(Slot slot) const {
    return at_present([&](const Data& data) {
        auto row = data.load(slot);
        row.template get<ansatz::Velocity>() = velocity_in(data, slot);
        return acceleration_of(data, slot, row);
    });
}

template <class... P> typename World<P...>::Velocity World<P...>::velocity_at(Slot slot) const {
    if constexpr (composition::history && composition::coupled)
        return at_present([&](const Data& data) { return velocity_in(data, slot); });
    return velocity_in(data_, slot);
}

template <class... P> typename World<P...>::Velocity World<P...>::velocity_in(const Data& data, Slot slot) const {
    auto row = data.load(slot);
    if constexpr (composition::history)
        if (!data.waiting(slot) && data.bodies.motion(slot) == Motion::awake && data.last_dt().value() > Scalar(0)) {
            auto& v = row.template get<ansatz::Velocity>();
            const Velocity mean = v;
            v = Integrator::velocity_now(mean, acceleration_of(data, slot, row), data.last_dt());
            // A force of velocity was asked at the velocity of half a step ago: an error of first order in what it
            // says, and, where velocities are read and given back in every step, in the motion.
            if constexpr (composition::velocity_read)
                v = Integrator::velocity_now(mean, acceleration_of(data, slot, row), data.last_dt());
        }
    return row.template get<ansatz::Velocity>();
}

/// For the door: the sums in place, so that asking for a velocity needs no copy.
template <class... P> void World<P...>::settle() {
    if constexpr (composition::history && composition::coupled) refresh_coupled(data_, policies_, context());
}

/// Before something changes what the laws do to one body: where velocity is derived from history with half a step of
/// the present acceleration, it is now what the old laws made it.
template <class... P> void World<P...>::hold_velocity([[maybe_unused]] Slot slot) {
    if constexpr (composition::history)
        if (data_.bodies.motion(slot) == Motion::awake) {
            settle();
            data_.set_velocity(slot, velocity_at(slot));
        }
}

template <class... P> void World<P...>::hold_velocities() {
    if constexpr (composition::history) {
        settle();
        for (std::size_t slot = 0; slot < data_.bodies.end(Motion::awake); ++slot) hold_velocity(Slot(slot));
    }
}

/// Before something changes what the forces between bodies see. Their sums are stale then; and where velocity is
/// derived from history, the change is made good when they are summed anew.
template <class... P> void World<P...>::forces_change() {
    if constexpr (composition::collides) data_.collisions.make_stale();
    if constexpr (composition::coupled) {
        if constexpr (composition::history)
            if (tick() > 0) {
                settle();
                data_.coupled.changed = true;
            }
        data_.coupled.current = false;
    }
}

template <class... P> Status World<P...>::status() const {
    Status s;
    s.lost = lost_;
    s.unsolved = data_.unsolved;
    for_each([&](Handle h) {
        const auto body = row(h);
        bool finite = true;
        [&]<class... C>(Columns<C...>) {
            ((finite = finite && is_finite(body.template get<C>())), ...);
        }(typename Data::AllColumns{});
        if (finite) return;
        if (s.not_finite++ == 0) s.first_not_finite = h;
    });
    return s;
}

} // namespace ansatz
