// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What a step does where bodies collide: the members of `Step` that find contacts, hand them to the responses, run
/// substeps for a response that owns them, and put islands to rest. Included by step.hpp.
// not in the umbrella: it is a part of step.hpp, which includes it

#include <ansatz/world/contact_step.hpp>
#include <ansatz/world/sleep.hpp>
#include <ansatz/world/step.hpp>
#include <ansatz/world/substeps.hpp>

namespace ansatz {

/// A response that owns substeps solves its contacts between them.
template <class C, class Policies> template <class Transient, bool Later> void Step<C, Policies>::in_substeps() {
    using R = typename detail::FirstOf<typename C::template responses<Level::substeps>>::type;
    constexpr double leads = detail::velocity_leads<I>();
    const detail::Bound<R, S> response(std::get<R>(policies_));
    auto& contacts = data_.template state<R>();
    data_.collisions.expect(context_.dt());
    settle();
    data_.collisions.refresh(data_, policies_, [&](Slot slot) {
        return this->acceleration(slot, data_.load(slot, context_.dt().previous));
    });
    const Scalar h = context_.dt().value() / Scalar(response.parts());
    const auto whole = context_;
    const auto start = data_.clock.now();
    auto last = context_.dt().previous;
    const auto acceleration = [&](Slot slot, const typename Data::Body& row) { return this->acceleration(slot, row); };
    SubstepBodies<C, decltype(acceleration)> bodies(data_, acceleration);
    auto& before = data_.collisions.before_solving();
    bodies.place(contacts.bodies, contacts.kicks);
    contacts.expect_platforms(data_.bodies.count(Motion::moving) > 0);
    contacts.begin(data_, [&](std::size_t a, std::size_t b) { return response.friction(data_, a, b); });
    bool bounces = response.find_bouncing(contacts, data_);
    const auto dt = S::Time::from_value(h);
    for (int part = 0; part < response.parts(); ++part) {
        context_ =
            Context<S>(start + S::ClockTime::from_value(typename S::ClockScalar(part) * typename S::ClockScalar(h)),
                       TimeStep<S>(dt, last));
        bound_.prepare(context_);
        if constexpr (C::history) complete_starts();
        if constexpr (C::coupled) refresh_coupled(data_, policies_, context_);
        bodies.gather(contacts.bodies, before, 0.5 + leads, dt, last, &contacts.kicks);
        if constexpr (C::rests)
            if (wake_the_hit(contacts, h)) { // others stand in other slots now
                bodies.place(contacts.bodies, contacts.kicks);
                const auto met = std::move(contacts.impacts.pairs);
                contacts.begin(data_, [&](std::size_t a, std::size_t b) { return response.friction(data_, a, b); });
                bounces = response.find_bouncing(contacts, data_);
                contacts.impacts.keep_met(met);
                if constexpr (C::history) complete_starts();
                bodies.gather(contacts.bodies, before, 0.5 + leads, dt, last, &contacts.kicks);
            }
        const bool struck = bounces && response.bounce(contacts, h);
        if (struck) bodies.scatter_late(contacts.bodies, before, contacts.impacts, -1 / h, last);
        contacts.warm_start();
        if (part == 0) contacts.unload(before);
        response.solve(contacts, h);
        bodies.scatter(contacts.bodies, before, last, &contacts.pushed);
        if constexpr (C::template couplings_read<Velocity>) data_.coupled.current = false;
        last = dt;
        part + 1 < response.parts() ? integrate<Columns<>, Later>() : integrate<Transient, Later>();
        if constexpr (C::coupled) {
            data_.coupled.current = false;
            refresh_coupled(data_, policies_, after());
        }
        bodies.gather(contacts.bodies, before, leads - 0.5, dt, last);
        if (struck) bodies.scatter_late(contacts.bodies, before, contacts.impacts, 1 / h, last);
        contacts.relax(h);
        contacts.calm(before);
        bodies.scatter(contacts.bodies, before, last);
    }
    if (bounces) contacts.note_impacts();
    data_.collisions.parts = response.parts();
    context_ = whole;
    if constexpr (C::coupled) data_.coupled.current = false;
}

/// A response that owns substeps stops what comes near before it touches. A sleeper would take that like a wall and
/// sleep on: who will be hit in this part of the step wakes before, or behind the part in which another was pushed into
/// it.
/// \param h s, the part
/// \return whether somebody was woken
template <class C, class Policies> bool Step<C, Policies>::wake_the_hit(auto& contacts, Scalar h) {
    if (data_.bodies.count(Motion::resting) == 0) return false;
    auto& hit = data_.sleep.value.sleepers;
    hit.clear();
    const auto rests = [&](Slot slot) { return data_.bodies.motion(slot) == Motion::resting; };
    contacts.each_acting([&](const auto& c) {
        const bool a_rests = rests(Slot(c.slot_a));
        if (!a_rests && !rests(Slot(c.slot_b))) return;
        const Scalar way = Scalar(1.25) * h * contacts.along(c); // who is woken in vain lies on
        if (!(c.impulse > Scalar(0)) && !(contacts.apart(c) + way < Scalar(0))) return;
        if (!data_.collisions.has_contact(c.a, c.b)) hit.push_back(a_rests ? c.a : c.b);
    });
    for (const auto id : hit)
        if (const auto slot = data_.bodies.slot_of_id(id); rests(slot)) wake_resting(data_, slot);
    if (hit.empty()) return false;
    wake_neighbours();
    return true;
}

/// Who lies together with somebody that was woken between two steps wakes before anything moves.
template <class C, class Policies> void Step<C, Policies>::wake_neighbours() {
    const auto acceleration = [&](Slot slot, const typename Data::Body& row) { return this->acceleration(slot, row); };
    ContactStep<C, Policies, decltype(acceleration)> contacts(data_, policies_, context_.dt(), acceleration);
    const auto wake = [&](Slot slot) { wake_resting(data_, slot); };
    do {
        if (data_.bodies.count(Motion::resting) == 0) return;
        if constexpr (C::collides) contacts.wake(wake, false);
    } while (detail::wake_through_elements(
        data_, [&](Slot slot) { return contacts.disturbs(slot, false); }, wake));
}

/// Bodies that would have passed each other are kept where they touched, with the velocity that they had there: what
/// the laws did to it on the way that is taken back is taken back, so that energy is what it was. With v_a along the
/// acceleration a and the way back delta, v_a^2 changes by 2 a . delta.
template <class C, class Policies> void Step<C, Policies>::hold_back() {
    const typename S::Time dt = context_.dt(), last = dt / Scalar(C::substeps ? data_.collisions.parts : 1);
    const auto next = context_.later(1.0);
    if constexpr (C::coupled && C::history) { // the velocity now is a question of the forces now
        data_.coupled.current = false;
        refresh_coupled(data_, policies_, next);
    }
    data_.collisions.hold_back(
        data_, policies_, false,
        [&](Slot slot, const typename S::Position& to, const typename S::Position& touched, Scalar lost) {
            auto row = data_.load(slot, last);
            const typename S::Acceleration a = bound_.laws.acceleration(row, next);
            typename S::Velocity v = row.template get<Velocity>();
            if constexpr (C::history)
                if (!data_.waiting(slot)) v = I::velocity_now(v, acceleration_at(slot, row, next), last);
            const auto size = robust_norm(a);
            if (size.value() > Scalar(0)) {
                const Vector<Scalar, S::dimension> along = a.value() / size.value();
                const typename S::Speed now = dot(v, along) + (Scalar(detail::velocity_leads<I>()) * size) * last;
                const auto squared =
                    now * now + Scalar(2) * dot(typename S::Position(touched - row.template get<Position>()), a);
                const typename S::Speed expected = now - (lost * size) * dt;
                typename S::Speed then =
                    squared.value() > Scalar(0) ? typename S::Speed(sqrt(squared)) : typename S::Speed();
                if (expected.value() < Scalar(0)) then = -then;
                v += (then - now) * along;
            }
            data_.lanes.template set<Position>(slot, to);
            if (C::history || size.value() > Scalar(0)) data_.set_velocity(slot, v);
        });
}

/// Who may come to touch is looked for by velocities and forces. A change that waits to be made good is made good
/// before, and in the same way as for a world that is saved now: or the loaded one would look by others, and find other
/// last bits.
template <class C, class Policies> void Step<C, Policies>::settle() {
    if constexpr (C::coupled)
        if (C::substeps || data_.coupled.changed)
            refresh_coupled(data_, policies_,
                            Context<S>(data_.clock.now(), TimeStep<S>(context_.dt().previous, context_.dt().previous)));
}

/// Contacts that are forces are looked for anew where bodies were changed, or a step is longer than the last one was.
template <class C, class Policies> void Step<C, Policies>::look_around() {
    if constexpr (C::acts_next && !C::substeps) {
        settle();
        data_.collisions.expect(context_.dt());
        if (!data_.collisions.refresh(data_, policies_,
                                      [&](Slot slot) { return bound_.laws.acceleration(data_.load(slot), context_); }))
            return;
        data_.coupled.current = false;
    }
}

/// Contacts are found where the bodies are now; they wake who sleeps, and the responses answer them.
template <class C, class Policies> void Step<C, Policies>::collide(bool later) {
    if constexpr (C::sweeps) hold_back();
    const auto next = context_.later(1.0);
    const auto acceleration = [&](Slot slot, const typename Data::Body& row) {
        return acceleration_at(slot, row, next);
    };
    if constexpr (C::holds_near) data_.collisions.near().step = context_.dt().value();
    data_.collisions.detect(
        data_, policies_,
        [&](Slot slot) {
            return C::substeps ? acceleration(slot, data_.load(slot, context_.dt()))
                               : bound_.laws.acceleration(data_.load(slot), next);
        },
        later);
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
        data_.collisions.hold_back(
            data_, policies_, true,
            [&](Slot slot, const typename S::Position& to, const auto&...) { contacts.place(slot, to); });
        data_.collisions.forget_impacts();
    }
    if constexpr (C::coupled) data_.coupled.current = false;
}

/// Where bodies collide or hang together, islands rest: those that touch each other fall asleep together.
template <class C, class Policies> void Step<C, Policies>::put_islands_to_rest() {
    if constexpr (C::collides)
        effects_only<Columns<>>(typename detail::EffectsFrom<S, typename C::resters>::type(std::get<Rester>(policies_)),
                                context_.dt());
    const detail::Bound<Rester, S> rest(std::get<Rester>(policies_));
    auto& scratch = data_.sleep.value;
    if constexpr (pull_varies) {
        scratch.held.assign(data_.bodies.size(), 0);
        if constexpr (C::collides)
            for (const auto& contact : data_.collisions.contacts)
                for (const auto& body : {contact.first, contact.second})
                    scratch.held[data_.bodies.slot_of_id(body.id)] = 1;
        begin_anew(rest, [&](std::size_t slot) { return scratch.held[slot] != 0; });
    }
    const auto* time = data_.lanes.template lane<RestTime>();
    find_sleepers(
        data_, scratch, [&](std::size_t slot) { return rest.long_enough(S::Time::from_value(time[slot])); },
        [&](Slot slot) { return pull_at_rest(slot, after()); }, [&](const auto& add) { add_pushes(add); },
        [&](const auto& remains) { return balanced(rest, remains); });
    for (const auto id : scratch.sleepers) put_to_rest(data_.bodies.slot_of_id(id));
    if constexpr (C::coupled)
        if (!scratch.sleepers.empty()) {
            data_.coupled.current = false;
            refresh_coupled(data_, policies_, after());
        }
    if constexpr (C::collides)
        for (const auto id : scratch.sleepers)
            data_.collisions.slept(id, pull_at_rest(data_.bodies.slot_of_id(id), after()));
}

/// What contacts did in the last substep, per time: friction, too.
template <class C, class Policies> void Step<C, Policies>::add_pushes([[maybe_unused]] const auto& add) const {
    if constexpr (C::substeps) {
        using R = typename detail::FirstOf<typename C::template responses<Level::substeps>>::type;
        const Scalar per_time = Scalar(data_.collisions.parts) / context_.dt().value();
        for (const auto& c : std::as_const(data_).template state<R>().all) {
            auto impulse = (c.impulse * c.normal).eval();
            if constexpr (R::rubs) impulse += c.rubbing;
            for (const auto& [id, sign] : {std::pair(c.a, Scalar(1)), std::pair(c.b, Scalar(-1))}) {
                const auto slot = data_.bodies.slot_of_id(id);
                add(slot, S::Acceleration::from_value(
                              (sign * per_time * data_.lanes.template get<InverseMass>(slot).value()) * impulse));
            }
        }
    }
}

} // namespace ansatz
