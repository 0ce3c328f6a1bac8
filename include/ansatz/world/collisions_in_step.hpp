// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What a step does where bodies collide: the members of `Step` that find contacts, hand them to the responses, run substeps for
/// a response that owns them, and put islands to rest. Included by step.hpp.
// not in the umbrella: it is a part of step.hpp, which includes it

#include <ansatz/world/contact_step.hpp>
#include <ansatz/world/sleep.hpp>
#include <ansatz/world/step.hpp>
#include <ansatz/world/substeps.hpp>

namespace ansatz {

/// A response that owns substeps solves its contacts between them.
template <class C, class Policies>
template <class Transient, bool Later>
void Step<C, Policies>::in_substeps() {
    using R = typename detail::FirstOf<typename C::template responses<Level::substeps>>::type;
    constexpr double leads = detail::velocity_leads<I>();
    const detail::Bound<R, S> response(std::get<R>(policies_));
    auto& contacts = data_.template state<R>();
    data_.collisions.expect(context_.dt());
    settle();
    data_.collisions.refresh(data_, policies_, [&](Slot slot) { return this->acceleration(slot, data_.load(slot, context_.dt().previous)); });
    const Scalar h = context_.dt().value() / Scalar(response.parts());
    const auto whole = context_;
    const auto start = data_.clock.now();
    auto last = context_.dt().previous;
    const auto acceleration = [&](Slot slot, const typename Data::Body& row) { return this->acceleration(slot, row); };
    SubstepBodies<C, decltype(acceleration)> bodies(data_, acceleration);
    auto& before = data_.collisions.before_solving();
    bodies.place(contacts.bodies);
    contacts.begin(data_, [&](std::size_t a, std::size_t b) { return response.friction(data_, a, b); });
    const bool bounces = response.find_bouncing(contacts, data_);
    const auto dt = S::Time::from_value(h);
    for (int part = 0; part < response.parts(); ++part) {
        context_ = Context<S>(start + S::ClockTime::from_value(typename S::ClockScalar(part) * typename S::ClockScalar(h)), TimeStep<S>(dt, last));
        bound_.prepare(context_);
        if constexpr (C::history) complete_starts();
        if constexpr (C::coupled) refresh_coupled(data_, policies_, context_);
        if (bounces && part == 0) {
            bodies.gather(contacts.bodies, before, leads, dt, last);
            response.remember_approaches(contacts, [&](const auto& c) { return pull_along(c); });
        }
        bodies.gather(contacts.bodies, before, 0.5 + leads, dt, last);
        response.solve(contacts, h);
        bodies.scatter(contacts.bodies, before, last);
        if constexpr (C::template couplings_read<Velocity>) data_.coupled.current = false;
        last = dt;
        part + 1 < response.parts() ? integrate<Columns<>, Later>() : integrate<Transient, Later>();
        if constexpr (C::coupled) {
            data_.coupled.current = false;
            refresh_coupled(data_, policies_, after());
        }
        bodies.gather(contacts.bodies, before, leads - 0.5, dt, last);
        contacts.relax(h);
        bodies.scatter(contacts.bodies, before, last);
    }
    if (bounces) {
        bodies.gather(contacts.bodies, before, leads, dt, last);
        contacts.restore();
        bodies.scatter(contacts.bodies, before, last);
    }
    data_.collisions.parts = response.parts();
    context_ = whole;
    if constexpr (C::coupled) data_.coupled.current = false;
}

/// N . (a_a - a_b) of a contact.
template <class C, class Policies>
typename Step<C, Policies>::Scalar Step<C, Policies>::pull_along(const auto& contact) const {
    Scalar sum(0);
    if (contact.slot_a < data_.bodies.end(Motion::awake)) sum += dot(acceleration(contact.slot_a, data_.load(contact.slot_a)).value(), contact.normal);
    if (contact.slot_b < data_.bodies.end(Motion::awake)) sum -= dot(acceleration(contact.slot_b, data_.load(contact.slot_b)).value(), contact.normal);
    return sum;
}

/// Who lies together with somebody that was woken between two steps wakes before anything moves.
template <class C, class Policies>
void Step<C, Policies>::wake_neighbours() {
    const auto acceleration = [&](Slot slot, const typename Data::Body& row) { return this->acceleration(slot, row); };
    ContactStep<C, Policies, decltype(acceleration)>(data_, policies_, context_.dt(), acceleration).wake([&](Slot slot) { wake_resting(data_, slot); }, false);
}

/// Bodies that would have passed each other are kept where they touched, with the velocity that they had there: what the laws did to
/// it on the way that is taken back is taken back, so that energy is what it was. With v_a along the acceleration a and the way
/// back delta, v_a^2 changes by 2 a . delta.
template <class C, class Policies>
void Step<C, Policies>::hold_back() {
    const typename S::Time dt = context_.dt(), last = dt / Scalar(C::substeps ? data_.collisions.parts : 1);
    const auto next = context_.later(1.0);
    if constexpr (C::coupled && C::history) { // the velocity now is a question of the forces now
        data_.coupled.current = false;
        refresh_coupled(data_, policies_, next);
    }
    data_.collisions.hold_back(data_, policies_, false, [&](Slot slot, const typename S::Position& to, const typename S::Position& touched, Scalar lost) {
        auto row = data_.load(slot, last);
        const typename S::Acceleration a = bound_.laws.acceleration(row, next);
        typename S::Velocity v = row.template get<Velocity>();
        if constexpr (C::history)
            if (!data_.waiting(slot)) v = I::velocity_now(v, acceleration_at(slot, row, next), last);
        const auto size = robust_norm(a);
        if (size.value() > Scalar(0)) {
            const Vector<Scalar, S::dimension> along = a.value() / size.value();
            const typename S::Speed now = dot(v, along) + (Scalar(detail::velocity_leads<I>()) * size) * last;
            const auto squared = now * now + Scalar(2) * dot(typename S::Position(touched - row.template get<Position>()), a);
            const typename S::Speed expected = now - (lost * size) * dt;
            typename S::Speed then = squared.value() > Scalar(0) ? typename S::Speed(sqrt(squared)) : typename S::Speed();
            if (expected.value() < Scalar(0)) then = -then;
            v += (then - now) * along;
        }
        data_.lanes.template set<Position>(slot, to);
        if (C::history || size.value() > Scalar(0)) data_.set_velocity(slot, v);
    });
}

/// Who may come to touch is looked for by velocities and forces. A change that waits to be made good is made good before, and in the
/// same way as for a world that is saved now: or the loaded one would look by others, and find other last bits.
template <class C, class Policies>
void Step<C, Policies>::settle() {
    if constexpr (C::coupled)
        if (C::substeps || data_.coupled.changed)
            refresh_coupled(data_, policies_, Context<S>(data_.clock.now(), TimeStep<S>(context_.dt().previous, context_.dt().previous)));
}

/// Contacts that are forces are looked for anew where bodies were changed, or a step is longer than the last one was.
template <class C, class Policies>
void Step<C, Policies>::look_around() {
    if constexpr (C::acts_next && !C::substeps) {
        settle();
        data_.collisions.expect(context_.dt());
        if (!data_.collisions.refresh(data_, policies_, [&](Slot slot) { return bound_.laws.acceleration(data_.load(slot), context_); })) return;
        data_.coupled.current = false;
    }
}

/// Contacts are found where the bodies are now; they wake who sleeps, and the responses answer them.
template <class C, class Policies>
void Step<C, Policies>::collide(bool later) {
    if constexpr (C::sweeps) hold_back();
    const auto next = context_.later(1.0);
    const auto acceleration = [&](Slot slot, const typename Data::Body& row) { return acceleration_at(slot, row, next); };
    data_.collisions.detect(
        data_, policies_, [&](Slot slot) { return C::substeps ? acceleration(slot, data_.load(slot, context_.dt())) : bound_.laws.acceleration(data_.load(slot), next); }, later);
    ContactStep<C, Policies, decltype(acceleration)> contacts(data_, policies_, context_.dt(), acceleration);
    if constexpr (C::rests) contacts.wake([&](Slot slot) { wake_resting(data_, slot); });
    if constexpr (C::coupled) {
        data_.coupled.current = false;
        refresh_coupled(data_, policies_, next);
    }
    auto respond = [&]<class... R>(Types<R...>) { (contacts.template respond<R>(), ...); };
    respond(typename C::template responses<Level::velocities>{});
    if constexpr (C::sweeps && C::parts) data_.collisions.remember(data_);
    respond(typename C::template responses<Level::positions>{});
    if constexpr (C::sweeps && C::parts) { // who was pushed far must not be pushed through somebody
        data_.collisions.hold_back(data_, policies_, true, [&](Slot slot, const typename S::Position& to, const auto&...) { contacts.place(slot, to); });
        data_.collisions.forget_impacts();
    }
    if constexpr (C::coupled) data_.coupled.current = false;
}

/// Where bodies collide, islands rest: bodies that touch each other fall asleep together.
template <class C, class Policies>
void Step<C, Policies>::put_islands_to_rest() {
    effects_only<Columns<>>(typename detail::EffectsFrom<S, typename C::resters>::type(std::get<Rester>(policies_)), context_.dt());
    const detail::Bound<Rester, S> rest(std::get<Rester>(policies_));
    const auto* time = data_.lanes.template lane<RestTime>();
    auto& scratch = data_.collisions.sleep_scratch();
    find_sleepers(
        data_, scratch, [&](std::size_t slot) { return rest.long_enough(S::Time::from_value(time[slot])); },
        [&](Slot slot) { return pull_at_rest(slot, after()); });
    for (const auto id : scratch.sleepers) put_to_rest(data_.bodies.slot_of_id(id));
    if constexpr (C::coupled)
        if (!scratch.sleepers.empty()) {
            data_.coupled.current = false;
            refresh_coupled(data_, policies_, after());
        }
    for (const auto id : scratch.sleepers) data_.collisions.slept(id, pull_at_rest(data_.bodies.slot_of_id(id), after()));
}

} // namespace ansatz
