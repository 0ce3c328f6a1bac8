// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `MotionDoor`: the members of `World` that read and change how its bodies move. Everything is converted and checked
/// before anything is changed, so that a refusal leaves the world as it was.

#include <ansatz/motion/present.hpp>
#include <ansatz/world/checked_value.hpp>
#include <ansatz/world/inside.hpp>

#include <span>
#include <type_traits>

namespace ansatz {

/// \tparam W the world, of which this is a base
/// \tparam C its composition
template <class W, class C> class MotionDoor {
public:
    using S = typename C::S;                       ///< the space
    using Integrator = typename C::Integrator;     ///< the integrator
    using Position = typename S::Position;         ///< m
    using Velocity = typename S::Velocity;         ///< m/s
    using Acceleration = typename S::Acceleration; ///< m/s^2

    /// \name Reading a body
    /// All throw std::out_of_range for a stale handle.
    /// @{
    /// Where the body is, in m.
    Position position(Handle body) const {
        const auto& data = inside().data;
        return data.lanes.template get<ansatz::Position>(data.bodies.slot(body, "World::position"));
    }
    /// The velocity at the present time. Where the integrator keeps history instead, it is derived: the mean velocity
    /// of the last step belongs to half a step ago, and half a step of the present acceleration brings it here.
    Velocity velocity(Handle body) const {
        const auto in = inside();
        return detail::velocity_at(in, in.data.bodies.slot(body, "World::velocity"));
    }
    /// What all forces together do to the body now. Where bodies act on each other and something was changed since the
    /// last step, this asks every force between bodies anew.
    Acceleration acceleration(Handle body) const {
        const auto in = inside();
        return detail::acceleration_at(in, in.data.bodies.slot(body, "World::acceleration"));
    }
    /// In kg; infinite for a fixed or moving body.
    typename S::Mass mass(Handle body) const {
        need_mass();
        const auto& data = inside().data;
        const auto inverse = data.lanes.template get<ansatz::InverseMass>(data.bodies.slot(body, "World::mass"));
        return typename S::Scalar(1) / inverse;
    }
    /// 1/m, in 1/kg; zero for a fixed or moving body.
    typename S::InverseMass inverse_mass(Handle body) const {
        need_mass();
        const auto& data = inside().data;
        return data.lanes.template get<ansatz::InverseMass>(data.bodies.slot(body, "World::inverse_mass"));
    }
    /// The values of one body, for queries such as potential energy.
    auto row(Handle body) const {
        const auto& data = inside().data;
        return data.load(data.bodies.slot(body, "World::row"));
    }
    /// The laws as they are bound, for the same queries.
    const typename C::Laws& laws() const { return detail::Key::bound(self()).laws; }
    /// The bodies that fell asleep and woke in the last step, or between it and the one before; kept until the next.
    /// Some may be removed by then.
    std::span<const Event> events() const {
        if constexpr (C::rests) return inside().data.events.now();
        return {};
    }
    /// @}

    /// \name Changing a body
    /// Each wakes a resting body. All throw std::out_of_range for a stale handle, std::invalid_argument for a value
    /// that is not finite; the world is then as it was.
    /// @{

    /// Puts the body somewhere else, exactly there: nothing is left of a PositionRemainder. It keeps its velocity,
    /// whatever the integrator, and is not drawn in between.
    template <class Q> void set_position(Handle body, const Q& x) {
        const auto in = ready(body, "World::set_position");
        auto slot = in.data.bodies.slot_of_id(body.id);
        const auto where = detail::finite_vector<S, unit::Length>("World::set_position", "position", x);
        detail::refresh_for(in, slot);
        const auto v = detail::velocity_at(in, slot);
        const auto kind = in.data.bodies.motion(slot);
        in.template tell<hook::BeforeChange<ansatz::Position>>();
        in.template tell<hook::Disturbed>(body.id);
        slot = in.data.bodies.slot_of_id(body.id); // bodies that this woke changed places with others
        in.data.put(slot, where);
        in.data.bodies.note_change(slot);
        if constexpr (C::history) {
            if (kind == Motion::fixed || kind == Motion::resting) in.data.stop(slot);
            else in.data.set_velocity(slot, v);
        }
        if constexpr (C::template stores<DrawnPosition>) in.data.lanes.template set<DrawnPosition>(slot, where);
        in.template tell<hook::Wake>(slot);
        in.template tell<hook::Placed>(body.id);
        // A rope that is taut now, and was not, pulls at sleepers and wakes them; what a solver holds pulls at nobody.
        if constexpr (C::held_couplings::size > 0) detail::wake_hanging(in, body.id);
    }
    /// \throws std::invalid_argument also for a fixed body, which has no velocity (add it as `moving`)
    template <class Q> void set_velocity(Handle body, const Q& v) {
        const auto in = ready(body, "World::set_velocity");
        const auto slot = in.data.bodies.slot_of_id(body.id);
        const auto value = detail::finite_vector<S, unit::Velocity>("World::set_velocity", "velocity", v);
        if (in.data.bodies.motion(slot) == Motion::fixed)
            refuse_value("World::set_velocity", "the body", "fixed", "a platform that moves is added as `moving`");
        in.template tell<hook::BeforeChange<ansatz::Velocity>>();
        in.data.set_velocity(slot, value);
        in.template tell<hook::Wake>(slot);
    }
    /// \param m kg, finite and greater than zero
    /// \throws std::invalid_argument also for a fixed or moving body, whose mass is infinite
    template <class Q> void set_mass(Handle body, const Q& m) {
        need_mass();
        const auto in = ready(body, "World::set_mass");
        const auto slot = in.data.bodies.slot_of_id(body.id);
        const auto inverse = detail::inverse_of_mass<S>("World::set_mass", m);
        const auto kind = in.data.bodies.motion(slot);
        if (kind == Motion::fixed || kind == Motion::moving)
            refuse_value("World::set_mass", "the body", name_of(kind),
                         "its mass is infinite; add a body that forces move instead");
        detail::hold_velocity(in, slot);
        if constexpr (C::history) // forces see the velocity that is held now
            in.template tell<hook::BeforeChange<ansatz::Velocity, ansatz::InverseMass>>();
        else in.template tell<hook::BeforeChange<ansatz::InverseMass>>();
        in.data.lanes.template set<ansatz::InverseMass>(slot, inverse);
        in.template tell<hook::Wake>(slot);
    }
    /// Changes the momentum at once by `j` (in N s). A body of infinite mass does not notice.
    template <class Q> void apply_impulse(Handle body, const Q& j) {
        need_mass();
        const auto in = ready(body, "World::apply_impulse");
        const auto slot = in.data.bodies.slot_of_id(body.id);
        const auto impulse = detail::finite_vector<S, unit::Momentum>("World::apply_impulse", "impulse", j);
        const auto inverse = in.data.lanes.template get<ansatz::InverseMass>(slot);
        if (!(inverse.value() > typename S::Scalar(0))) return;
        detail::refresh_for(in, slot);
        const auto v = detail::velocity_at(in, slot) + inverse * impulse;
        if (!is_finite(v)) refuse_value("World::apply_impulse", "impulse", j, "the velocity after it is finite");
        in.template tell<hook::BeforeChange<ansatz::Velocity>>();
        in.data.set_velocity(slot, v);
        in.template tell<hook::Wake>(slot);
    }
    /// Wakes a resting body; does nothing to others.
    void wake(Handle body) {
        const auto in = ready(body, "World::wake");
        in.template tell<hook::Wake>(in.data.bodies.slot_of_id(body.id));
    }
    /// @}

private:
    W& self() { return static_cast<W&>(*this); }
    const W& self() const { return static_cast<const W&>(*this); }
    auto inside() const { return detail::Key::inside(self()); }
    /// Before a body is changed: it is there, and what has to be noted has room.
    auto ready(Handle body, const char* where) {
        const auto in = detail::Key::inside(self());
        in.data.bodies.slot(body, where);
        detail::Key::get_ready(self(), where);
        return in;
    }
    static constexpr void need_mass() {
        static_assert(C::has_mass, "Ansatz: this world stores no mass, because none of its policies needs it (gravity "
                                   "accelerates every mass alike); add Keep<InverseMass>{} to its policies");
    }
};

} // namespace ansatz
