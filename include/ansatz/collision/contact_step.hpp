// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What contacts do within a step: they are found, wake sleeping bodies, and are answered by the world's responses
/// (notes 2.2).
///
/// A response answers one contact at a time, in the order of the bodies' ids: it is given where and how the two
/// intersect and the columns of both that it declared, and changes the ones that it writes. Here its answer is brought
/// to the bodies: a velocity through the integrator, which defines it, and a new place with the history
/// that belongs to it. What rests or is fixed has no inverse mass here.

#include <ansatz/collision/facts.hpp>
#include <ansatz/motion/sleep.hpp>
#include <ansatz/motion/state.hpp>

#include <cstdint>
#include <tuple>
#include <type_traits>
#include <utility>

namespace ansatz {

namespace detail {
/// By how much of a step the velocity that an integrator keeps is ahead of the position: under constant acceleration
/// the velocity at the position's time is v + leads a dt, and the motion from one to the other is exact.
template <class I> constexpr double velocity_leads() {
    if constexpr (requires { I::velocity_leads; }) return I::velocity_leads;
    return 0;
}
} // namespace detail

/// What a response may ask beside the contact and the bodies.
/// \tparam Pull a function
template <class S, class Pull> struct ContactContext {
    typename S::Time dt;      ///< of the step that brought them together, s
    typename S::Scalar leads; ///< the velocity at the time of the position is v + leads a dt
    bool parted;              ///< whether a response of this world will move them apart
    const Pull& pull;         ///< `pull()`: N . (a_a - a_b), what pulls them apart, m/s^2; negative towards each other
};

/// The contacts of one step.
/// \tparam Acceleration a function of a slot and of a body's values
template <class C, class Policies, class Acceleration> class ContactStep {
public:
    using S = typename C::S; ///< the space
    using Scalar = typename S::Scalar;
    using Data = WorldData<C>;        ///< what it works on
    using Slot = typename Data::Slot; ///< a body's place in the lanes

    /// Of a step of this length.
    ContactStep(Data& data, const Policies& policies, const typename S::Time& dt, const Acceleration& acceleration)
        : data_(data), policies_(policies), dt_(dt), acceleration_(acceleration) {}

    /// Wakes resting bodies that are hit, that stand on what moves, and all that lie together with them.
    /// \param first whether contacts have just been found, so that those that begin wake
    template <class Wake> void wake(Wake&& wake, bool first = true) {
        bool more = data_.bodies.count(Motion::resting) > 0 && data_.bodies.any_goes();
        data_.collisions.wake_contacts(data_);
        while (more) {
            more = false;
            data_.collisions.each_acting(data_, [&](const auto& contact) {
                if (!data_.collisions.lasts(data_.bodies, contact)) return false;
                bool woke = false;
                for (const auto& [one, other] :
                     {std::pair(contact.first, contact.second), std::pair(contact.second, contact.first)}) {
                    const auto sleeper = data_.bodies.slot_of_id(one.id);
                    if (data_.bodies.motion(sleeper) != Motion::resting ||
                        !disturbs(data_, data_.bodies.slot_of_id(other.id), first && contact.begins(), dt_))
                        continue;
                    if (data_.collisions.is_sensor(one.id) || data_.collisions.is_sensor(other.id)) continue;
                    wake(sleeper);
                    woke = true;
                }
                more = more || woke;
                return woke;
            });
            first = false;
        }
    }

    /// Answers every contact by one response.
    template <class R> void respond() {
        const detail::Bound<R, S> response(std::get<R>(policies_));
        if constexpr (detail::answers_as_one<R>) return respond_as_one<R>(response);
        for (int sweep = 0, sweeps = sweeps_of(response); sweep < sweeps; ++sweep)
            for (const auto& contact : data_.collisions.contacts.acting)
                if (!data_.collisions.is_sensor(contact.first.id) && !data_.collisions.is_sensor(contact.second.id))
                    answer<R>(response, contact);
    }

    /// Moves a body, with its history.
    void place(Slot slot, const typename S::Position& to) {
        data_.displace(slot, to - data_.lanes.template get<Position>(slot));
    }

    /// Once contacts, or being stopped on the way, have given some bodies a velocity, every other body is given the one
    /// that it has, too. The forces between bodies change by what was done. A velocity that is derived from a history
    /// would change with them by half a step, and one that was given would not, so that momentum would be lost.
    void hold_velocities() {
        if constexpr (C::history && C::coupled)
            if (!data_.starts.none())
                for (std::size_t slot = 0; slot < data_.bodies.end(Motion::awake); ++slot)
                    if (!data_.waiting(Slot(slot))) data_.set_velocity(Slot(slot), value<Velocity>(Slot(slot)));
    }

private:
    /// What a response sees of a body.
    template <class R> using Body = Row<S, union_of<writes_of<R>, reads_of<R>, Columns<InverseMass>>>;

    static int sweeps_of(const auto& response) {
        if constexpr (requires { response.sweeps; }) return response.sweeps;
        return 1;
    }
    /// All contacts together, and pairs that nearly touch.
    template <class R> void respond_as_one(const detail::Bound<R, S>& response) {
        constexpr bool moves = detail::contains<Position, writes_of<R>>;
        auto& pushes = data_.collisions.pushes();
        pushes.clear(data_.bodies.size());
        for (const auto& contact : data_.collisions.contacts.acting) add<R, true>(response, contact);
        if constexpr (C::holds_near) {
            auto found = data_.collisions.contacts.acting
                             .cbegin(); // a body that was stopped on its way is both in contact and near
            const auto ids = [](const auto& c) { return detail::ids_of(c); };
            for (const auto& contact : data_.collisions.near().all) {
                while (found != data_.collisions.contacts.acting.cend() && ids(*found) < ids(contact)) ++found;
                if (found == data_.collisions.contacts.acting.cend() || ids(*found) != ids(contact))
                    add<R, false>(response, contact);
            }
        }
        if (pushes.pushes.empty()) return;
        pushes.arrange();
        response.answer(pushes, dt_, Scalar(detail::velocity_leads<typename C::Integrator>()), C::separates,
                        [&](const auto& push) {
                            const auto of = [&](std::uint32_t n) {
                                return pull_at(pushes.bodies[n].slot, pushes.bodies[n].weight > Scalar(0));
                            };
                            return dot(of(push.a) - of(push.b), push.normal);
                        });
        for (const auto& body : pushes.bodies) {
            if (!(body.weight > Scalar(0)) || body.u == body.was) continue;
            if constexpr (moves) data_.displace(body.slot, S::Position::from_value(body.u));
            else data_.set_velocity(body.slot, S::Velocity::from_value(body.u));
        }
    }
    template <class R, bool Touches> void add(const detail::Bound<R, S>& response, const auto& contact) {
        constexpr bool moves = detail::contains<Position, writes_of<R>>;
        if (data_.collisions.is_sensor(contact.first.id) || data_.collisions.is_sensor(contact.second.id)) return;
        const Slot slot_a = data_.bodies.slot_of_id(contact.first.id),
                   slot_b = data_.bodies.slot_of_id(contact.second.id);
        const bool free_a = data_.bodies.motion(slot_a) == Motion::awake,
                   free_b = data_.bodies.motion(slot_b) == Motion::awake;
        const auto a = load<R>(slot_a, free_a), b = load<R>(slot_b, free_b);
        const auto weight = [](const auto& body) { return body.template get<InverseMass>().value(); };
        if (!(weight(a) + weight(b) > Scalar(0))) return;
        auto now = contact;
        if constexpr (moves && C::template responses<Level::positions>::size > 1) // another one may have moved them
            if (!C::Narrowphase::template collide_bodies<S>(
                    data_.collisions.shapes, contact.first.id, data_.lanes.template get<Position>(slot_a),
                    contact.second.id, data_.lanes.template get<Position>(slot_b), now))
                return;
        auto& pushes = data_.collisions.pushes();
        using Pushes = std::remove_cvref_t<decltype(pushes)>;
        const auto u = [](const auto& body) {
            if constexpr (moves) return typename Pushes::Raw(Pushes::Raw::Zero());
            else return typename Pushes::Raw(body.template get<Velocity>().value());
        };
        auto& push = pushes.pushes.emplace_back();
        push.a = pushes.body(slot_a, weight(a), [&] { return u(a); });
        push.b = pushes.body(slot_b, weight(b), [&] { return u(b); });
        push.which = std::uint32_t(pushes.pushes.size() - 1);
        push.normal = now.normal;
        push.point = now.point.value();
        push.depth = now.depth.value();
        push.touches = Touches || !(push.depth < Scalar(0));
        response.note(push, a, b);
    }

    template <class R> void answer(const detail::Bound<R, S>& response, const auto& contact) {
        const Slot slot_a = data_.bodies.slot_of_id(contact.first.id),
                   slot_b = data_.bodies.slot_of_id(contact.second.id);
        const bool free_a = data_.bodies.motion(slot_a) == Motion::awake,
                   free_b = data_.bodies.motion(slot_b) == Motion::awake;
        if (!free_a && !free_b) return;
        auto now = contact;
        if constexpr (detail::contains<Position, writes_of<R>>) // others may have moved them since they were found
            if (!C::Narrowphase::template collide_bodies<S>(
                    data_.collisions.shapes, contact.first.id, data_.lanes.template get<Position>(slot_a),
                    contact.second.id, data_.lanes.template get<Position>(slot_b), now))
                return;
        auto a = load<R>(slot_a, free_a), b = load<R>(slot_b, free_b);
        const auto was_a = a, was_b = b;
        const auto pull = [&] { return dot(pull_at(slot_a, free_a) - pull_at(slot_b, free_b), now.normal); };
        response.respond(now, a, b,
                         ContactContext<S, decltype(pull)>{
                             dt_, Scalar(detail::velocity_leads<typename C::Integrator>()), C::separates, pull});
        if (free_a) store<R>(slot_a, was_a, a);
        if (free_b) store<R>(slot_b, was_b, b);
    }
    typename S::Acceleration pull_at(Slot slot, bool is_free) const {
        if (!is_free) return S::template zero_vector<unit::Acceleration>();
        return acceleration_(slot, data_.load(slot, dt_));
    }

    // A function and no lambda, on which clang++ ignores the attribute.
    template <class... Column>
    [[gnu::always_inline]] void load_columns(auto& row, Slot slot, Columns<Column...>) const {
        ((row.template get<Column>() = value<Column>(slot)), ...);
    }
    template <class R> [[gnu::always_inline]] Body<R> load(Slot slot, bool is_free) const {
        Body<R> row;
        load_columns(row, slot, typename Body<R>::columns{});
        if (!is_free) row.template get<InverseMass>() = typename S::InverseMass();
        return row;
    }
    template <class Column> [[gnu::always_inline]] value_of<Column, S> value(Slot slot) const {
        if constexpr (C::history && std::same_as<Column, Velocity>) {
            auto row = data_.load(slot, dt_);
            if (!data_.waiting(slot) && data_.bodies.motion(slot) == Motion::awake)
                row.template get<Velocity>() =
                    C::Integrator::velocity_now(row.template get<Velocity>(), acceleration_(slot, row), dt_);
            return row.template get<Velocity>();
        } else return data_.lanes.template get<Column>(slot);
    }
    template <class R> void store(Slot slot, const Body<R>& was, const Body<R>& is) {
        auto one = [&]<class Column>(Columns<Column>) {
            const auto& to = is.template get<Column>();
            if (to == was.template get<Column>()) return;
            if constexpr (std::same_as<Column, Velocity>) data_.set_velocity(slot, to);
            else if constexpr (std::same_as<Column, Position>) data_.displace(slot, to - was.template get<Position>());
            else data_.lanes.template set<Column>(slot, to);
        };
        [&]<class... Column>(Columns<Column...>) { (one(Columns<Column>{}), ...); }(writes_of<R>{});
    }
    Data& data_;
    const Policies& policies_;
    typename S::Time dt_;
    const Acceleration& acceleration_;
};

} // namespace ansatz
