// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The door of a world: the members of `World` that take values from outside and check them. Everything is converted
/// and checked before anything is changed, so that a refusal leaves the world as it was. Included by world.hpp.
// not in the umbrella: it is the second half of world.hpp, which includes it

#include <ansatz/world/declaration.hpp>
#include <ansatz/world/fields.hpp>
#include <ansatz/world/hash.hpp>

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

template <class... P> template <class... Property> Handle World<P...>::add(const Property&... property) {
    using Facts = detail::AddFacts<composition, Datum, Property...>;
    using Asked = typename detail::ModulesAsked<composition, Property...>::type;
    static_assert(sizeof(detail::CheckAdd<Facts>) > 0);
    if constexpr (Facts::ok) static_assert(detail::read_adds<composition, Property...>(Asked{}));
    Handle body;
    if constexpr (Facts::ok && detail::takes<composition, Property...>) {
        using Row_ = Row<S, union_of<typename composition::stored, Columns<Position, Velocity>>>;
        Row_ row{};
        (take(row, property), ...);
        auto datum = detail::given_datum<Datum>(property...); // copied now, because a copy may throw
        const auto admitted = detail::admit<composition>(typename composition::modules{}, property...);
        get_ready("World::add");
        grow();
        const auto id = data_.bodies.next_id();
        if constexpr (has_datum) user_.make_room(id);
        data_.make_room(id, Facts::is_moving);
        detail::make_room_to_keep(typename composition::modules{}, data_, admitted);
        tell<hook::BeforeChange<>>();
        if constexpr (has_datum) user_.at(id) = std::move(datum);
        detail::keep(typename composition::modules{}, data_, id, admitted);
        // From here on nothing fails.
        Slot slot = Slot(size());
        data_.lanes.push_back();
        body = data_.bodies.push_back();
        [&]<class... C>(Columns<C...>) {
            (data_.lanes.template set<C>(slot, row.template get<C>()), ...);
        }(typename composition::stored{});
        slot = data_.move(slot, Facts::is_fixed     ? Motion::fixed
                                : Facts::is_moving  ? Motion::moving
                                : Facts::is_resting ? Motion::resting
                                                    : Motion::awake);
        data_.template tell<hook::Added>(slot, row);
        if constexpr (Facts::is_fixed || Facts::is_moving) tell<hook::Placed>(body.id);
    }
    return body;
}

template <class... P> template <class C, class Q> void World<P...>::write(Handle body, const Q& value) {
    need_column<C>();
    static_assert(!std::same_as<C, Position> && !std::same_as<C, Velocity> && !std::same_as<C, PreviousPosition>,
                  "Ansatz: position and velocity are changed by set_position and set_velocity, because the integrator "
                  "owns what they mean");
    static_assert(!std::same_as<C, InverseMass>,
                  "Ansatz: a mass is changed by set_mass, which holds it to be positive");
    static_assert(!std::same_as<C, AppliedForce> && !std::same_as<C, CoupledForce> && !std::same_as<C, RestTime> &&
                      !std::same_as<C, DrawnPosition> && !std::same_as<C, PositionRemainder>,
                  "Ansatz: the world itself writes this column; a force from outside is given by apply_force, a place "
                  "by set_position");
    auto slot = data_.bodies.slot(body, "World::write");
    get_ready("World::write");
    const auto checked_value = detail::value_for<S, C>("World::write", value);
    tell<hook::BeforeWrite<C>>(slot);
    tell<hook::BeforeChange<C>>();
    if constexpr (detail::matters_to_neighbours<C, composition>) tell<hook::Disturbed>(body.id);
    slot = data_.bodies.slot_of_id(body.id); // bodies that this woke changed places with others
    data_.lanes.template set<C>(slot, checked_value);
    data_.bodies.note_change(slot); // a force may see it, of a fixed body, too
    tell<hook::Wake>(slot);
    if constexpr (detail::matters_to_neighbours<C, composition>) tell<hook::Placed>(body.id);
}

template <class... P> template <class Policy> void World<P...>::set(const Policy& policy) {
    constexpr bool there = (std::same_as<Policy, P> || ...);
    static_assert(there, "Ansatz: set: this world has no such policy; see the list in its type");
    if constexpr (there) {
        get_ready("World::set");
        auto changed = policies_;
        std::get<Policy>(changed) = policy;
        auto bound = BoundPolicies<composition>::from(checked(changed));
        tell<hook::BeforeSet<Policy>>();
        policies_ = std::move(changed);
        bound_ = std::move(bound);
        tell<hook::AfterSet<Policy>>();
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
        if constexpr (detail::any_brings_bodies<typename composition::keepers, S>)
            make_room_to_come(data_.bodies_to_come(policies_));
        tell<hook::CheckStep>(h, dt);
        int parts = 1;
        if constexpr (composition::controlled) { // it may refuse the step, so that it is asked before anything changes
            constexpr bool understood = StepControlFor<std::decay_t<decltype(control())>, World>;
            static_assert(
                understood,
                "Ansatz: a policy that decides how a step is taken, with a wrong signature; it needs `struct Kept` and "
                "`int parts(const auto& world, const Quantity<unit::Time>& dt, Kept& kept) const`");
            if constexpr (understood) parts = control().parts(*this, scalar_cast<double>(dt), data_.control.value);
            if (parts < 1)
                refuse_value("World::step", "the number of substeps that its StepControl says", parts,
                             "it is at least 1");
            if (parts > 1) tell<hook::CheckStep>(typename S::Time(h / Scalar(parts)), dt);
        }
        lost_ = true; // until it is taken
        const auto first = step_of(h);
        tell<hook::BeforeStep>(first);
        data_.template tell<hook::BeginStep>();
        data_.states.for_each([](auto& state) {
            if constexpr (requires { state.begin_step(); }) state.begin_step();
        });
        const auto whole = scalar_cast<typename S::ClockScalar>(dt);
        if (!composition::controlled || parts == 1) take_step<typename composition::transient>(whole);
        else if constexpr (composition::controlled) {
            const auto part = whole / typename S::ClockScalar(parts);
            take_step<Columns<>>(part);
            for (int i = 2; i < parts; ++i) take_step<Columns<>, true>(part);
            take_step<typename composition::transient, true>(part);
        }
        follow_divisions();
        lost_ = false;
    }
}

template <class... P> TimeStep<typename World<P...>::S> World<P...>::step_of(const typename S::Time& dt) const {
    return TimeStep<S>(dt, tick() == 0 ? dt : data_.last_dt());
}

template <class... P> template <class Transient, bool Later> void World<P...>::take_step(const ClockTime& dt) {
    ansatz::take_step<Transient, Later>(data_, policies_, bound_, step_of(S::Time::from_value(Scalar(dt.value()))), dt);
}

template <class... P> Status World<P...>::status() const {
    Status s;
    s.lost = lost_;
    data_.template ask<hook::Report>(s);
    (let_say<P>(s), ...);
    for_each([&](Handle h) {
        bool finite = true;
        data_.template ask<hook::IsFinite>(data_.bodies.slot_of_id(h.id), finite);
        if (finite) return;
        if (s.not_finite++ == 0) s.first_not_finite = h;
    });
    return s;
}

template <class... P> template <class Policy> void World<P...>::let_say([[maybe_unused]] Status& status) const {
    if constexpr (detail::names_report<Policy>) {
        constexpr bool understood = requires(const Policy& policy, const Quantity<unit::Time>& dt) {
            { policy.report(*this, dt) } -> std::same_as<std::string>;
        };
        static_assert(understood,
                      "Ansatz: a policy that has something to say in status(), with a wrong signature; it "
                      "needs `std::string report(const auto& world, const Quantity<unit::Time>& dt) const`");
        if constexpr (understood) {
            if (tick() == 0 || status.lost) return; // no step has a length yet, or the last was not whole
            int parts = 1;
            inside().template tell<hook::NextSubsteps>(parts);
            const std::string said =
                get<Policy>().report(*this, scalar_cast<double>(data_.clock.last()) / double(parts));
            if (!said.empty()) status.said += (status.said.empty() ? "" : "; ") + said;
        }
    }
}

template <class... P> std::uint64_t World<P...>::hash() const {
    StateHash hash;
    data_.clock.add_to(hash);
    data_.template ask<hook::HashCounts>(hash);
    data_.bodies.add_free_to(hash);
    data_.states.for_each([&](const auto& state) { detail::hash_state(hash, state); });
    data_.template ask<hook::Hash>(hash);
    for_each([&](Handle h) {
        const auto slot = data_.bodies.slot_of_id(h.id);
        hash.add(h.id);
        hash.add(h.generation);
        hash.add(std::uint64_t(data_.bodies.motion(slot)));
        data_.template ask<hook::HashBody>(slot, hash);
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
