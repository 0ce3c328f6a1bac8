// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What a step does where bodies collide: contacts are found and handed to the responses, and bodies that were hit
/// wake. What a response does that owns substeps is in substep_driver.hpp.

#include <ansatz/collision/contact_step.hpp>
#include <ansatz/motion/rest_step.hpp>

namespace ansatz {

/// Collisions in a step, or in a substep.
template <class StepT> class CollisionStep : public MotionStep<StepT> {
    using Base = MotionStep<StepT>;

protected:
    using Base::bound_;
    using Base::context_;
    using Base::data_;
    using Base::policies_;
    using Base::step_;

public:
    using Base::Base;
    using typename Base::C;
    using typename Base::Data;
    using typename Base::I;
    using typename Base::Policies;
    using typename Base::S;
    using typename Base::Scalar;
    using typename Base::Slot;
    using typename Base::Transient;

    /// Contacts are found where the bodies are now; they wake sleeping bodies, and the responses answer them.
    void collide() {
        if constexpr (C::continuous) hold_back();
        const auto next = context_.later(1.0);
        const auto acceleration = [&](Slot slot, const typename Data::Body& row) {
            return this->acceleration_at(slot, row, next);
        };
        if constexpr (C::holds_near) data_.collisions.near().step = context_.dt().value();
        data_.collisions.detect(
            data_, policies_,
            [&](Slot slot) -> typename S::Acceleration {
                if constexpr (C::asked == LawsAsked::and_left) return this->own_acceleration(slot);
                else if constexpr (!C::substeps) return bound_.laws.acceleration(data_.load(slot), next);
                else {
                    if constexpr (shares)
                        if (data_.own.value.known) return this->known_acceleration(slot);
                    return acceleration(slot, data_.load(slot, context_.dt()));
                }
            },
            StepT::later);
        if constexpr (shares) data_.own.value.known = false;
        ContactStep<C, Policies, decltype(acceleration)> contacts(data_, policies_, context_.dt(), acceleration);
        if constexpr (C::rests) contacts.wake([&](Slot slot) { wake_resting(data_, slot); });
        if constexpr (C::coupled) {
            data_.coupled.current = false;
            refresh_coupled(data_, policies_, next);
        }
        auto respond = [&]<class... R>(Types<R...>) {
            if (data_.bodies.any_goes()) (contacts.template respond<R>(), ...);
        };
        respond(typename C::template responses<Level::velocities>{});
        contacts.hold_velocities();
        if constexpr (C::continuous && C::separates) data_.collisions.remember(data_);
        respond(typename C::template responses<Level::positions>{});
        if constexpr (C::continuous && C::separates) { // a body that was pushed far must not be pushed through another
            data_.collisions.hold_back(
                data_, policies_, true,
                [&](Slot slot, const typename S::Position& to, const auto&...) { contacts.place(slot, to); });
            data_.collisions.forget_impacts();
        }
        if constexpr (C::coupled) data_.coupled.current = false;
    }

    /// Where bodies are before they move.
    void remember() { data_.collisions.remember(data_); }
    /// Wakes the neighbours of bodies that were woken between two steps.
    void wake_touching() {
        const auto acceleration = [&](Slot slot, const typename Data::Body& row) {
            return this->acceleration(slot, row);
        };
        ContactStep<C, Policies, decltype(acceleration)> contacts(data_, policies_, context_.dt(), acceleration);
        contacts.wake([&](Slot slot) { wake_resting(data_, slot); }, false);
    }
    /// The accelerations by contacts in the last substep, friction included.
    void add_pushes([[maybe_unused]] const auto& add) const {
        if constexpr (C::substeps) {
            using R = typename detail::FirstIn<typename C::template responses<Level::substeps>>::type;
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

protected:
    /// Whether the laws are asked once for the response and the integrator.
    static constexpr bool shares = C::asked == LawsAsked::beforehand;

    /// Bodies that may come to touch are found by velocities and forces, so that a change that waits to be made good is
    /// made good first.
    void refresh_forces() {
        if constexpr (C::coupled)
            if (C::substeps || data_.coupled.changed)
                refresh_coupled(
                    data_, policies_,
                    Context<S>(data_.clock.now(), TimeStep<S>(context_.dt().previous, context_.dt().previous)));
    }

private:
    /// Bodies that would have passed each other are kept where they touched, with the velocity that they had there:
    /// the work of the laws on the way that is taken back is taken back too, so that the energy is kept. With v_a
    /// along the acceleration a and the way back delta, v_a^2 changes by 2 a . delta.
    void hold_back() {
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
                    if (!data_.waiting(slot)) v = I::velocity_now(v, this->acceleration_at(slot, row, next), last);
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
                data_.put(slot, to);
                if (C::history || size.value() > Scalar(0)) data_.set_velocity(slot, v);
            });
        const auto acceleration = [&](Slot slot, const typename Data::Body& row) {
            return this->acceleration_at(slot, row, next);
        };
        ContactStep<C, Policies, decltype(acceleration)>(data_, policies_, last, acceleration).hold_velocities();
    }
};
template <class StepT> CollisionStep(StepT&) -> CollisionStep<StepT>; ///< of a step

/// Contacts that are forces are searched for anew where bodies were changed, or a step is longer than the last one was.
template <class InsideT>
void look_around([[maybe_unused]] const InsideT& inside, [[maybe_unused]] const TimeStep<typename InsideT::S>& dt) {
    using C = typename InsideT::Composition_;
    using S = typename C::S;
    if constexpr (C::acts_next && !C::substeps) {
        auto& data = inside.data;
        if constexpr (C::coupled)
            if (data.coupled.changed)
                refresh_coupled(data, inside.policies,
                                Context<S>(data.clock.now(), TimeStep<S>(dt.previous, dt.previous)));
        data.collisions.expect(dt);
        const Context<S> context(data.clock.now(), dt);
        auto bound = inside.bound;
        bound.prepare(context);
        if (!data.collisions.refresh(data, inside.policies, [&](Bodies::Slot slot) {
                return bound.laws.acceleration(data.load(slot), context);
            }))
            return;
        data.coupled.current = false;
    }
}

} // namespace ansatz
