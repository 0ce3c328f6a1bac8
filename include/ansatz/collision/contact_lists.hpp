// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `ContactLists`: the contacts of a world in two lists, those that act in a step and those of bodies that sleep (notes
/// 1.1), and as one where they are asked for.

#include <ansatz/collision/contact.hpp>
#include <ansatz/collision/sleeping_contacts.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace ansatz {

/// The contacts of a world, by the ids of their bodies.
template <class S> class ContactLists {
public:
    /// Those that a step goes through: a body of them may move, or has fallen asleep in the last step.
    std::vector<Contact<S>> acting;

    /// Whether some are kept apart, because their bodies sleep.
    bool any_sleep() const { return !asleep_.empty(); }
    /// How many.
    std::size_t asleep() const { return asleep_.size(); }
    /// Acting and sleeping ones; asked for once or a hundred times in a step, they are put together once.
    const std::vector<Contact<S>>& all() const {
        if (asleep_.empty()) return acting;
        return joined_.get([&](auto& list) {
            list.reserve(acting.size() + asleep_.size());
            asleep_.each(
                acting, [&](const Contact<S>& c) { list.push_back(c); },
                [&](const Contact<S>& c) { list.push_back(lasted(c)); });
        });
    }
    /// Whether two bodies are in contact; the one with the smaller id first.
    bool has(std::uint32_t a, std::uint32_t b) const {
        const auto at = std::lower_bound(acting.begin(), acting.end(), std::pair(a, b),
                                         [](const auto& c, const auto& ids) { return detail::ids_of(c) < ids; });
        return (at != acting.end() && detail::ids_of(*at) == std::pair(a, b)) || asleep_.has(a, b);
    }
    /// Whether a body has contacts that sleep.
    bool has_sleeping(std::uint32_t id) const { return asleep_.has(id); }
    /// Calls `f(contact)` for all contacts of a body, in any order.
    void each_of(std::uint32_t id, auto&& f) const {
        for (const auto& c : acting)
            if (c.first.id == id || c.second.id == id) f(c);
        asleep_.each_of(id, f);
    }
    /// A step is done: those that sleep have lasted one more.
    void sleep_on() {
        ++steps_;
        changed();
    }
    /// Those that act are others now.
    void changed() { joined_.forget(); }

    /// \name Contacts that fall asleep, and that act again
    /// @{
    /// Room for so many that fall asleep, of bodies with ids below `ids`.
    void make_room_to_sleep(std::size_t n, std::size_t ids) { asleep_.make_room(n, ids); }
    /// Those for which `sleeps` holds are kept apart. With room for them, it cannot fail.
    void put_to_sleep(const auto& sleeps) {
        for (auto& c : acting)
            if (sleeps(c)) c.steps -= steps_; // counts round where it has lasted less: it is added again
        asleep_.take(acting, sleeps);
        changed();
    }
    /// Room for those that sleep among those that act.
    void make_room_to_wake() {
        if (acting.capacity() < acting.size() + asleep_.size()) acting.reserve(acting.size() + asleep_.size());
        asleep_.make_room_to_leave();
        ahead_.reserve(asleep_.size());
    }
    /// A body has woken, or has been removed: its contacts will act once `wake` is called. It cannot fail.
    void leave(std::uint32_t id) {
        asleep_.leave(id, [](std::uint32_t) {});
    }
    /// The same within `each_acting`, where its contacts are visited, too, if they stand behind one.
    void leave(std::uint32_t id, const Contact<S>& behind) {
        asleep_.leave(id, [&](std::uint32_t place) {
            if (!(detail::ids_of(behind) < detail::ids_of(asleep_[place]))) return;
            ahead_.push_back(place);
            std::push_heap(ahead_.begin(), ahead_.end(), later());
        });
    }
    /// Calls `f(contact)` for those that act and those that `leave` meanwhile, in the order of their ids.
    void each_acting(auto&& f) {
        for (std::size_t n = 0; n < acting.size() || !ahead_.empty();)
            if (!ahead_.empty() && (n == acting.size() || ids_at(ahead_.front()) < detail::ids_of(acting[n]))) {
                std::pop_heap(ahead_.begin(), ahead_.end(), later());
                const auto next = ahead_.back();
                ahead_.pop_back();
                f(lasted(asleep_[next]));
            } else f(acting[n++]);
    }
    /// Whether any has left.
    bool any_left() const { return asleep_.any_left(); }
    /// Those that have left act. With room for them, it cannot fail.
    void wake() {
        asleep_.merge(acting, [&](const auto& c) { return lasted(c); });
        changed();
    }
    /// @}
    /// Room for what another holds, so that assigning it cannot fail.
    void make_room_for(const ContactLists& other) {
        acting.reserve(other.acting.size());
        asleep_.make_room_for(other.asleep_);
    }

private:
    Contact<S> lasted(Contact<S> c) const {
        c.steps += steps_;
        return c;
    }
    auto ids_at(std::uint32_t place) const { return detail::ids_of(asleep_[place]); }
    /// The order of a heap whose first is the one that comes next.
    auto later() const {
        return [this](std::uint32_t a, std::uint32_t b) { return ids_at(b) < ids_at(a); };
    }

    SleepingContacts<Contact<S>> asleep_; // how many steps each has lasted is counted without `steps_`
    std::uint32_t steps_ = 0;             // in which some have slept
    std::vector<std::uint32_t> ahead_;    // within `each_acting`: places of those still to come, a heap
    detail::MadeWhenAsked<Contact<S>> joined_;
};

} // namespace ansatz
