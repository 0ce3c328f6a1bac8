// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What keeps a world whole: members of `World`. A verb that fails, for lack of memory or because a type of yours
/// throws, leaves the world as it was: whatever may fail is done before anything is changed. A step is not undone,
/// which would cost a copy of the world for each; one that is broken off leaves a world that says that it is lost.
/// Included by world.hpp.
// not in the umbrella: it is a part of world.hpp, which includes it

#include <ansatz/world/declaration.hpp>

#include <algorithm>
#include <string>
#include <type_traits>
#include <utility>

namespace ansatz {

template <class... P> void World<P...>::remove(Handle body) {
    data_.bodies.slot(body, "World::remove");
    get_ready("World::remove");
    data_.find_named();
    const auto erase = [&] {
        tell<hook::BeforeChange<>>();
        tell<hook::Disturbed>(body.id);
        // The slot is asked for last: bodies that this woke changed places with others.
        data_.erase(data_.bodies.slot_of_id(body.id));
    };
    if constexpr (has_datum) {
        Datum nothing{}; // which may fail
        erase();
        user_.at(body.id) = std::move(nothing);
    } else erase();
}

template <class... P> void World<P...>::reserve(std::size_t n) {
    if (n >= 0xffffffffu)
        refuse_value("World::reserve", "n", n, "it is below 4294967295, the number of bodies that handles can name");
    data_.reserve(n);
    if constexpr (has_datum) user_.by_id.reserve(n);
    capacity_ = std::max<std::size_t>(capacity_, n); // last: where one table found no memory, it is asked for again
}

template <class... P> void World<P...>::grow() {
    if (size() + 1 > capacity_) reserve(std::max<std::size_t>({8, 2 * std::size_t(capacity_), 2 * size()}));
}

/// Room for bodies that policies may add within a step: made before it, and only for the first that needs it.
template <class... P> void World<P...>::make_room_to_come(std::size_t bodies) {
    const std::size_t all = std::max(data_.bodies.ids(), size() + bodies);
    if (all > capacity_) reserve(all);
    else data_.reserve_notes(all);
    if (bodies == 0) return;
    data_.make_room_to_come(bodies);
    if constexpr (has_datum) user_.make_room(std::uint32_t(data_.bodies.ids() + bodies - 1));
}

/// Behind a step: a body that was made by dividing another gets a copy of its datum.
template <class... P> void World<P...>::follow_divisions() {
    if constexpr (Data::notes_divisions && std::is_copy_assignable_v<Datum>) {
        for (const auto& [id, part] : data_.divisions.value) user_.at(part) = user_.at(id);
        data_.divisions.value.clear();
    }
}

/// Before a verb changes anything: what it may have to note has room.
template <class... P> void World<P...>::get_ready(const char* where) {
    if (lost_) refuse_lost(where);
    data_.reserve_notes(data_.bodies.ids());
}

/// What may fail, first. In the room that is there, where nothing in a world owns memory of its own kind: who rolls
/// back in every frame allocates nothing. What a broken step left of caches is not kept.
template <class... P> void World<P...>::assign(const World& other) {
    if constexpr (Data::assigns_in_place && detail::DataOfUser<Datum>::assigns_in_place)
        if (!lost_) {
            auto policies = other.policies_;
            auto bound = other.bound_;
            data_.make_room_for(other.data_);
            user_.make_room_for(other.user_);
            data_ = other.data_;
            user_ = other.user_;
            policies_ = std::move(policies);
            bound_ = std::move(bound);
            lost_ = other.lost_;
            return;
        }
    World copy(other);
    copy.reserve(capacity_);
    *this = std::move(copy);
}

template <class... P> void World<P...>::assign(World&& other) {
    policies_ = std::move(other.policies_);
    bound_ = std::move(other.bound_);
    data_ = std::move(other.data_);
    user_ = std::move(other.user_);
    capacity_ = std::move(other.capacity_);
    lost_ = other.lost_;
}

template <class... P> void World<P...>::refuse_lost(const char* where) {
    refuse(Refusal::invalid_argument,
           detail::joined({where, ": this world is lost, because its last step was broken off by an exception; "
                                  "assign a copy that was made before, or load one"}));
}

} // namespace ansatz
