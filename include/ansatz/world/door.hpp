// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The door of a world: the members of `World` that take values from outside and check them. Everything is converted
/// and checked before anything is changed, so that a refusal leaves the world as it was. Included by world.hpp.
// not in the umbrella: it is the second half of world.hpp, which includes it

#include <ansatz/world/add_facts.hpp>
#include <ansatz/world/checked_value.hpp>
#include <ansatz/world/column_range.hpp>
#include <ansatz/world/hash.hpp>
#include <ansatz/world/hash_collisions.hpp>
#include <ansatz/world/sleep.hpp>
#include <ansatz/world/smallest_step.hpp>
#include <ansatz/world/world.hpp>

namespace ansatz {

template <class... P>
template <class Row_, class Property>
void World<P...>::take(Row_& row, const Property& property) {
    if constexpr (detail::is_given<Property>) {
        using C = typename Property::column;
        if constexpr (detail::is_given_mass<Property>) {
            row.template get<C>() = detail::inverse_of_mass<S>("World::add", property.value);
        } else {
            if constexpr (!std::same_as<C, ansatz::Position> && !std::same_as<C, ansatz::Velocity>) need_column<C>();
            row.template get<C>() = detail::value_for<S, C>("World::add", property.value);
        }
    }
}

template <class... P> template <class... C> void World<P...>::column_changes() {
    if constexpr (composition::collides)
        data_.collisions.make_stale(); // whom it may meet in the next step is looked for again
    if constexpr ((composition::template couplings_read<C> || ...)) forces_change();
}

template <class... P> void World<P...>::wake_slot([[maybe_unused]] Slot slot) {
    if constexpr (composition::rests) {
        data_.lanes.template set<RestTime>(slot, typename S::Time());
        if (data_.bodies.motion(slot) != Motion::resting) return;
        data_.events.between_steps({Event::Kind::woke, data_.bodies.handle(slot)});
        if (!data_.waiting(slot)) data_.begin_again(slot);
        data_.move(slot, Motion::awake);
    }
}

/// Who lay on a body, or held it, does not know any more whether it stays.
template <class... P> void World<P...>::wake_contacts([[maybe_unused]] std::uint32_t id) {
    if constexpr (composition::rests && composition::collides)
        for (const auto& contact : data_.collisions.contacts) {
            if (!data_.collisions.lasts(data_.bodies, contact)) continue;
            if (contact.first.id == id) wake_slot(data_.bodies.slot_of_id(contact.second.id));
            if (contact.second.id == id) wake_slot(data_.bodies.slot_of_id(contact.first.id));
        }
    if constexpr (composition::islands)
        if (count(Motion::resting) > 0) // and who hangs on it
            detail::for_each_element(data_, [&](const auto& state, std::uint32_t element) {
                bool holds = false;
                state.for_each_body(element, [&](std::uint32_t body) { holds = holds || body == id; });
                if (holds) wake_ends(state, element);
            });
}

/// What moves wakes by itself whom it hits; what stands still and was put where somebody sleeps does so here.
template <class... P> void World<P...>::wake_pierced([[maybe_unused]] std::uint32_t id) {
    if constexpr (composition::rests && composition::collides) {
        if (data_.bodies.motion(data_.bodies.slot_of_id(id)) == Motion::awake || data_.collisions.is_sensor(id)) return;
        for (std::size_t slot = data_.bodies.begin(Motion::resting); slot < data_.bodies.end(Motion::resting); ++slot) {
            const auto sleeper = data_.bodies.id(slot);
            if (sleeper == id || data_.collisions.is_sensor(sleeper) || !data_.collisions.intersect(data_, id, sleeper))
                continue;
            wake_slot(Slot(slot)); // the first of the sleepers, who was looked at, takes this place
        }
    }
}

template <class... P> template <class... Property> Handle World<P...>::add(const Property&... property) {
    using Facts = detail::AddFacts<composition, Datum, Property...>;
    static_assert(sizeof(detail::CheckAdd<Facts>) > 0);
    Handle body;
    if constexpr (Facts::ok) {
        using Row_ = Row<S, union_of<typename composition::stored, Columns<ansatz::Position, ansatz::Velocity>>>;
        Row_ row{};
        (take(row, property), ...);
        auto datum = detail::given_datum<Datum>(property...); // copied now, because a copy may throw
        const auto description = detail::given_shape(property...);
        const auto shape = detail::shape_in<S>(description);
        get_ready("World::add");
        grow();
        const auto id = data_.bodies.next_id();
        if constexpr (has_datum) user_.make_room(id);
        data_.make_room(id, Facts::is_moving);
        forces_change();
        if constexpr (has_datum) user_.at(id) = std::move(datum);
        if constexpr (composition::collides && ShapeDescription<std::decay_t<decltype(description)>>)
            data_.collisions.shapes.set(id, description, shape);
        // From here on nothing fails.
        Slot slot = Slot(size());
        data_.lanes.push_back();
        body = data_.bodies.push_back();
        [&]<class... C>(Columns<C...>) {
            (data_.lanes.template set<C>(slot, row.template get<C>()), ...);
        }(typename composition::stored{});
        if constexpr (composition::template stores<DrawnPosition>)
            data_.lanes.template set<DrawnPosition>(slot, row.template get<ansatz::Position>());
        slot = data_.move(slot, Facts::is_fixed     ? Motion::fixed
                                : Facts::is_moving  ? Motion::moving
                                : Facts::is_resting ? Motion::resting
                                                    : Motion::awake);
        if constexpr (Facts::is_fixed || Facts::is_resting) data_.stop(slot);
        else data_.set_velocity(slot, row.template get<ansatz::Velocity>());
        if constexpr (composition::collides)
            data_.collisions.set_sensor(body.id, (std::same_as<Property, Sensor> || ...));
        if constexpr (Facts::is_fixed || Facts::is_moving) wake_pierced(body.id);
    }
    return body;
}

template <class... P> template <class Q> void World<P...>::set_position(Handle body, const Q& x) {
    auto slot = data_.bodies.slot(body, "World::set_position");
    get_ready("World::set_position");
    const auto where = detail::finite_vector<S, unit::Length>("World::set_position", "position", x);
    settle();
    const auto v = velocity_at(slot);
    const auto kind = data_.bodies.motion(slot);
    column_changes<ansatz::Position>();
    wake_contacts(body.id);
    slot = data_.bodies.slot_of_id(body.id); // whom that woke changed places with others
    data_.lanes.template set<ansatz::Position>(slot, where);
    if constexpr (composition::history) {
        if (kind == Motion::fixed || kind == Motion::resting) data_.stop(slot);
        else data_.set_velocity(slot, v);
    }
    if constexpr (composition::template stores<DrawnPosition>) data_.lanes.template set<DrawnPosition>(slot, where);
    wake_slot(slot);
    wake_pierced(body.id);
}

template <class... P> template <class Q> void World<P...>::set_velocity(Handle body, const Q& v) {
    const auto slot = data_.bodies.slot(body, "World::set_velocity");
    get_ready("World::set_velocity");
    const auto value = detail::finite_vector<S, unit::Velocity>("World::set_velocity", "velocity", v);
    if (data_.bodies.motion(slot) == Motion::fixed)
        refuse_value("World::set_velocity", "the body", "fixed", "a platform that moves is added as `moving`");
    column_changes<ansatz::Velocity>();
    data_.set_velocity(slot, value);
    wake_slot(slot);
}

template <class... P> template <class Q> void World<P...>::set_mass(Handle body, const Q& m) {
    need_mass();
    const auto slot = data_.bodies.slot(body, "World::set_mass");
    get_ready("World::set_mass");
    const auto inverse = detail::inverse_of_mass<S>("World::set_mass", m);
    const auto kind = data_.bodies.motion(slot);
    if (kind == Motion::fixed || kind == Motion::moving)
        refuse_value("World::set_mass", "the body", name_of(kind),
                     "its mass is infinite; add a body that forces move instead");
    hold_velocity(slot);
    if constexpr (composition::history)
        column_changes<ansatz::Velocity, ansatz::InverseMass>(); // forces see the velocity that is held now
    else column_changes<ansatz::InverseMass>();
    data_.lanes.template set<ansatz::InverseMass>(slot, inverse);
    wake_slot(slot);
}

template <class... P> template <class Q> void World<P...>::apply_impulse(Handle body, const Q& j) {
    need_mass();
    const auto slot = data_.bodies.slot(body, "World::apply_impulse");
    get_ready("World::apply_impulse");
    const auto impulse = detail::finite_vector<S, unit::Momentum>("World::apply_impulse", "impulse", j);
    const auto inverse = data_.lanes.template get<ansatz::InverseMass>(slot);
    if (!(inverse.value() > Scalar(0))) return;
    settle();
    const auto v = velocity_at(slot) + inverse * impulse;
    if (!is_finite(v)) refuse_value("World::apply_impulse", "impulse", j, "the velocity after it is finite");
    column_changes<ansatz::Velocity>();
    data_.set_velocity(slot, v);
    wake_slot(slot);
}

template <class... P> template <class Q> void World<P...>::apply_force(Handle body, const Q& f) {
    static_assert(composition::template stores<AppliedForce>,
                  "Ansatz: this world takes no forces from outside; add AppliedForces{} to its policies");
    const auto slot = data_.bodies.slot(body, "World::apply_force");
    get_ready("World::apply_force");
    const auto force = detail::finite_vector<S, unit::Force>("World::apply_force", "force", f);
    if (!(data_.lanes.template get<ansatz::InverseMass>(slot).value() > Scalar(0))) return;
    const auto total = data_.lanes.template get<AppliedForce>(slot) + force;
    if (!is_finite(total)) refuse_value("World::apply_force", "force", f, "the sum of the forces applied is finite");
    // The velocity now is what it was before the force; the history begins anew with both.
    hold_velocity(slot);
    if constexpr (composition::history) column_changes<ansatz::Velocity>(); // forces see the velocity that is held now
    column_changes<AppliedForce>();
    data_.lanes.template set<AppliedForce>(slot, total);
    wake_slot(slot);
}

template <class... P> template <class C, class Q> void World<P...>::write(Handle body, const Q& value) {
    need_column<C>();
    static_assert(!std::same_as<C, ansatz::Position> && !std::same_as<C, ansatz::Velocity> &&
                      !std::same_as<C, PreviousPosition>,
                  "Ansatz: position and velocity are changed by set_position and set_velocity, because the integrator "
                  "owns what they mean");
    static_assert(!std::same_as<C, ansatz::InverseMass>,
                  "Ansatz: a mass is changed by set_mass, which holds it to be positive");
    static_assert(!std::same_as<C, AppliedForce> && !std::same_as<C, CoupledForce> && !std::same_as<C, RestTime> &&
                      !std::same_as<C, DrawnPosition>,
                  "Ansatz: the world itself writes this column; a force from outside is given by apply_force, a place "
                  "by set_position");
    auto slot = data_.bodies.slot(body, "World::write");
    get_ready("World::write");
    const auto checked_value = detail::value_for<S, C>("World::write", value);
    // What no force reads leaves the velocity what it is, to the bit.
    if constexpr (detail::contains<C, typename composition::Laws::needs> || composition::template couplings_read<C>) {
        hold_velocity(slot);
        if constexpr (composition::history) column_changes<ansatz::Velocity>();
    }
    column_changes<C>();
    if constexpr (composition::template collisions_read<C>)
        wake_contacts(body.id);              // who lies on it may fall, or bounce
    slot = data_.bodies.slot_of_id(body.id); // whom that woke changed places with others
    data_.lanes.template set<C>(slot, checked_value);
    wake_slot(slot);
    if constexpr (composition::template collisions_read<C>) wake_pierced(body.id);
}

template <class... P> template <class Policy> void World<P...>::set(const Policy& policy) {
    constexpr bool there = (std::same_as<Policy, P> || ...);
    static_assert(there, "Ansatz: set: this world has no such policy; see the list in its type");
    if constexpr (there) {
        get_ready("World::set");
        auto changed = policies_;
        std::get<Policy>(changed) = policy;
        auto bound = BoundPolicies<composition>::from(checked(changed));
        // The velocity now is what the old forces made it; only from here on the new ones act.
        if constexpr (PlaysRole<Policy, roles::Force> || detail::IsCoupling<Policy>::value) {
            hold_velocities();
            if constexpr (composition::coupled) data_.coupled.current = false;
        }
        policies_ = std::move(changed);
        bound_ = std::move(bound);
        if constexpr (PlaysRole<Policy, roles::Broadphase>) data_.collisions.new_broadphase();
        if constexpr (PlaysRole<Policy, roles::Filter>) data_.collisions.make_stale();
        if constexpr (PlaysRole<Policy, roles::Force> || PlaysRole<Policy, roles::Effect> ||
                      PlaysRole<Policy, roles::Response> || PlaysRole<Policy, roles::Filter>)
            wake_all();
    }
}

template <class... P> auto World<P...>::query() const {
    need_collisions();
    if constexpr (composition::collides) {
        using Asked = typename composition::Narrowphase::template Query<composition, Policies>;
        constexpr bool defined = requires { sizeof(Asked); };
        static_assert(defined, "Ansatz: query: what answers it is not included; write #include "
                               "<ansatz/collision/queries_in_world.hpp>, or "
                               "<ansatz/collision.hpp> for all of collision");
        if constexpr (defined) return Asked(data_, policies_);
    }
}

template <class... P> template <class T> void World<P...>::step(const T& dt) {
    detail::refuse_whole_numbers<T>();
    const auto h = detail::finite_scalar<S, unit::Time>("World::step", "dt", dt);
    if constexpr (detail::fits_scalar<unit::Time, T>) {
        if (h.value() < Scalar(0)) refuse_value("World::step", "dt", dt, "a time step is finite and not negative");
        if (!is_finite(data_.clock.now() + scalar_cast<typename S::ClockScalar>(dt)))
            refuse_value("World::step", "dt", dt, "the time after the step is finite");
        if (h.value() == Scalar(0)) {
            if (!(dt.value() == 0))
                refuse_value("World::step", "dt", dt, "a time step is 0 or one that the world's scalar can hold");
            return;
        }
        get_ready("World::step");
        data_.reserve_notes_of_step();
        detail::refuse_short_step(data_, policies_, h, dt);
        int parts = 1;
        if constexpr (composition::controlled) { // it may refuse the step, so that it is asked before anything changes
            constexpr bool understood = StepControlFor<std::decay_t<decltype(control())>, World>;
            static_assert(
                understood,
                "Ansatz: a policy that decides how a step is taken, with a wrong signature; it needs `struct Kept` and "
                "`int parts(const auto& world, const Quantity<unit::Time>& dt, Kept& kept) const`");
            if constexpr (understood) parts = control().parts(*this, scalar_cast<double>(dt), data_.control.value);
        }
        lost_ = true; // until it is taken
        if constexpr (composition::acts_next) step_of(h).look_around();
        Step<composition, Policies>::begin(data_);
        const auto whole = scalar_cast<typename S::ClockScalar>(dt);
        if (!composition::controlled || parts == 1) take_step<typename composition::transient>(whole);
        else if constexpr (composition::controlled) {
            const auto part = whole / typename S::ClockScalar(parts);
            take_step<Columns<>>(part);
            for (int i = 2; i < parts; ++i) take_step<Columns<>, true>(part);
            take_step<typename composition::transient, true>(part);
        }
        lost_ = false;
    }
}

template <class... P> auto World<P...>::step_of(const typename S::Time& dt) {
    return Step<composition, Policies>(data_, policies_, bound_, TimeStep<S>(dt, tick() == 0 ? dt : data_.last_dt()));
}

template <class... P> template <class Transient, bool Later> void World<P...>::take_step(const ClockTime& dt) {
    step_of(S::Time::from_value(Scalar(dt.value()))).template run<Transient, Later>(dt);
}

template <class... P> std::uint64_t World<P...>::hash() const {
    // A change that waits to be made good is part of the state.
    if constexpr (composition::history && composition::coupled)
        if (data_.coupled.changed) {
            World settled = *this;
            refresh_coupled(settled.data_, settled.policies_, settled.context());
            return settled.hash();
        }
    StateHash hash;
    data_.clock.add_to(hash);
    hash.add(data_.unsolved);
    data_.bodies.add_free_to(hash);
    data_.states.for_each([&](const auto& state) { state.add_to(hash); });
    if constexpr (composition::collides) detail::add_collisions_to<composition>(hash, data_);
    for_each([&](Handle h) {
        const auto slot = data_.bodies.slot_of_id(h.id);
        hash.add(h.id);
        hash.add(h.generation);
        hash.add(std::uint64_t(data_.bodies.motion(slot)));
        hash.add(data_.waiting(slot));
        // A sum, because the order of the policies, and with it that of the columns, means nothing.
        std::uint64_t columns = 0;
        [&]<class... C>(Columns<C...>) {
            auto column = [&]<class One>(Columns<One>) {
                StateHash values;
                for (const char letter : std::string_view(One::name)) values.add(std::uint64_t(letter));
                for (std::size_t k = 0; k < lanes_of<One>(S::dimension); ++k)
                    values.add_number(data_.lanes.template lane<One>(int(k))[slot]);
                columns += values.value();
            };
            (column(Columns<C>{}), ...);
        }(typename composition::state{});
        hash.add(columns);
    });
    return hash.value();
}

} // namespace ansatz
