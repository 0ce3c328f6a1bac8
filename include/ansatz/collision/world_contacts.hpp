// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `WorldContacts`: the contacts of a world from step to step. Those that go on are recognised; those of bodies that
/// sleep are kept apart, with what responses keep of them, until a body wakes or is taken away (notes 1.1).

#include <ansatz/collision/contact_lists.hpp>
#include <ansatz/collision/contact_order.hpp>
#include <ansatz/collision/facts.hpp>
#include <ansatz/collision/sleep.hpp>
#include <ansatz/world/bodies.hpp>
#include <ansatz/world/cache.hpp>
#include <ansatz/world/data.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace ansatz {

/// \tparam C the world's composition
template <class C> class WorldContacts {
public:
    using S = typename C::S;       ///< the space
    ContactLists<S> contacts;      ///< by the ids of their bodies; see `lasts`
    std::vector<ContactEnd> ended; ///< what was a contact before the last step and is none now
    /// Whether contacts of sleeping bodies are kept apart; the results are the same to the bit either way.
    bool keeps_apart = true;

    /// Whether two bodies were in contact when the last step was done; the one with the smaller id first.
    bool has_contact(std::uint32_t a, std::uint32_t b) const { return contacts.has(a, b); }
    /// Whether both bodies of a contact are still there.
    bool lasts(const Bodies& bodies, const Contact<S>& c) const {
        return !body_removed_ || (bodies.contains(c.first) && bodies.contains(c.second));
    }
    /// Room for the neighbours of a body among so many.
    void reserve_neighbours(std::size_t n) { neighbours_.value.reserve(n); }
    /// Calls `f(id)` for each body in contact with one, by their ids. With room for them, it cannot fail.
    void each_neighbour(const Bodies& bodies, std::uint32_t id, const auto& f) const {
        auto& neighbours = neighbours_.value;
        neighbours.clear();
        contacts.each_of(id, [&](const auto& c) {
            if (lasts(bodies, c)) neighbours.push_back(c.first.id == id ? c.second.id : c.first.id);
        });
        std::sort(neighbours.begin(), neighbours.end());
        for (const auto neighbour : neighbours) f(neighbour);
    }
    /// Where bodies have woken or were removed since, their contacts act again. If it fails, none does.
    template <class Data> void wake_contacts(Data& data) {
        if (woken_ == data.bodies.woken() && !body_removed_) return;
        if (contacts.any_sleep()) {
            make_room_to_wake(data);
            for (std::size_t slot = 0; slot < data.bodies.end(Motion::awake); ++slot) leave(data, data.bodies.id(slot));
            wake(data);
        }
        woken_ = data.bodies.woken();
    }
    /// Room for all of them.
    template <class Data> void make_room_to_wake(Data& data) {
        contacts.make_room_to_wake();
        each_acting_state(data, [](auto& state) { state.make_room_to_wake(); });
    }
    /// Those of one body act again. With room for them, it cannot fail.
    template <class Data> void wake_contacts_of(Data& data, std::uint32_t id) {
        leave(data, id);
        wake(data);
    }
    /// Calls `f(contact)` for each that acts, in the order of their ids. Where it returns that it has woken bodies of
    /// the contact, theirs act, too; those that stand behind it are still visited.
    template <class Data> void each_acting(Data& data, const auto& f) {
        if (contacts.any_sleep()) make_room_to_wake(data);
        contacts.each_acting([&](const auto& contact) {
            if (!f(contact) || !contacts.any_sleep()) return;
            for (const auto id : {contact.first.id, contact.second.id})
                if (data.bodies.motion(data.bodies.slot_of_id(id)) == Motion::awake) leave(data, id, contact);
        });
        wake(data);
    }

protected:
    /// Responses that act in the next step.
    using NextStep = std::conditional_t<C::substeps, typename C::template responses<Level::substeps>,
                                        typename C::template responses<Level::accelerations>>;

    /// A body has been removed; the ends of its contacts are reported in the next step.
    void body_gone(std::uint32_t id) {
        body_removed_ = true;
        contacts.leave(id);
    }
    /// The same of a world that is loaded, before there are contacts.
    void some_are_gone() { body_removed_ = true; }
    /// Whether a body was removed since the last step.
    bool any_gone() const { return body_removed_; }
    /// Replaces the acting contacts by those that were found.
    /// \param later whether this is a substep and not the first
    /// \param stays which of those that were found; see `compare_contacts`
    void compare(std::vector<Contact<S>>& found, bool later, auto stays) {
        detail::equal_room(contacts.acting, found);
        if (!later) ended.clear();
        detail::compare_contacts(contacts.acting, found, ended, later, stays);
        contacts.acting.swap(found);
        contacts.changed();
        body_removed_ = false;
    }
    /// No body has moved since contacts were found: they stay, a step older.
    void go_on(bool later) {
        if (later) return;
        ended.clear();
        contacts.sleep_on();
        for (auto& contact : contacts.acting) ++contact.steps;
    }
    /// Contacts of bodies that have slept for a whole step leave those that steps go through.
    /// \param n how many there are; with none there is nothing to do
    template <class Data> void put_contacts_to_sleep([[maybe_unused]] Data& data, [[maybe_unused]] std::size_t n) {
        if constexpr (can_keep_apart<Data>()) {
            if (n == 0 || !keeps_apart) return;
            const auto sleeps = [&](const auto& pair) { return detail::sleeps<C>(data, pair); };
            const auto ids = data.bodies.ids();
            contacts.make_room_to_sleep(n, ids);
            each_acting_state(data, [&](auto& state) { state.make_room_to_sleep(n, ids); });
            contacts.put_to_sleep(sleeps);
            each_acting_state(data, [&](auto& state) { state.put_to_sleep(sleeps); });
        }
    }

private:
    /// Whether all responses that keep data of contacts can keep that of sleeping ones apart.
    template <class Data> static constexpr bool can_keep_apart() {
        if constexpr (!C::rests || !C::acts_next) return C::rests;
        else
            return []<class... R>(Types<R...>) {
                return (requires(Data& data) { data.template state<R>().wake_contacts(); } && ...);
            }(NextStep{});
    }
    /// A body has woken.
    /// \param behind within `each_acting`, the contact that is visited
    template <class Data> void leave(Data& data, std::uint32_t id, const auto&... behind) {
        if (!contacts.has_sleeping(id)) return;
        contacts.leave(id, behind...);
        each_acting_state(data, [id](auto& state) { state.leave(id); });
    }
    /// The contacts that have left act.
    template <class Data> void wake(Data& data) {
        if (!contacts.any_left()) return;
        contacts.wake();
        each_acting_state(data, [](auto& state) { state.wake_contacts(); });
    }
    template <class Data> static void each_acting_state([[maybe_unused]] Data& data, [[maybe_unused]] auto&& f) {
        if constexpr (C::acts_next && can_keep_apart<Data>())
            [&]<class... R>(Types<R...>) { (f(data.template state<R>()), ...); }(NextStep{});
    }

    mutable detail::Cache<std::vector<std::uint32_t>> neighbours_; // ids
    bool body_removed_ = false;                                    // since the last step
    std::uint64_t woken_ = 0;                                      // bodies, when their contacts were searched for last
};

} // namespace ansatz
