// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `ContactOrder`: puts contacts in the order of their bodies' ids, so that sleeping, waking and the broadphase do not
/// decide in which order bodies are pushed; and what can be asked of contacts that stand so.
///
/// A counting sort by the first id, then the contacts of each by the second: the work grows with the contacts and
/// bodies, not with a logarithm of them, but where one body has many. Contacts that are in order already, as those of
/// sleeping bodies are, are merged with the others and not sorted.

#include <ansatz/collision/contact.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace ansatz {

namespace detail {
/// Gives two lists that are about to change places the same room: otherwise a step that has long had all the room that
/// it needs finds some day that the list with little room has come round.
template <class T> void equal_room(std::vector<T>& a, std::vector<T>& b) {
    a.reserve(b.capacity());
    b.reserve(a.capacity());
}
} // namespace detail

/// Sorts contacts; keeps the room that it needs.
template <class S> class ContactOrder {
public:
    /// Room for so many ids.
    void reserve(std::size_t ids) {
        begin_.reserve(ids + 1);
        next_.reserve(ids + 1);
        keys_.reserve(ids);
    }
    /// Those of one pair stay as they stood to each other.
    /// \param ids     one more than the largest id
    /// \param ordered how many, at the end, are in order among themselves
    void sort(std::vector<Contact<S>>& contacts, std::size_t ids, std::size_t ordered = 0) {
        const std::size_t found = contacts.size() - ordered;
        if (ordered == 0 && are_in_order(contacts)) {
            reserve(ids); // for the first that are not
            sorted_.reserve(contacts.capacity());
            return;
        }
        if (found < ids / 8) sort_few(contacts, found);
        else sort_many(contacts, found, ids);
        if (ordered == 0) {
            detail::equal_room(contacts, sorted_);
            contacts.swap(sorted_);
        } else merge(contacts, found);
    }

private:
    /// Up to so many contacts of a body are put in order as they come.
    static constexpr std::uint32_t few = 16;
    struct Key {
        std::uint64_t ids;   // or one of them
        std::uint32_t place; // before sorting
        friend bool operator<(const Key& a, const Key& b) {
            return a.ids < b.ids || (a.ids == b.ids && a.place < b.place);
        }
    };
    static std::uint64_t ids_of(const Contact<S>& c) { return std::uint64_t(c.first.id) << 32 | c.second.id; }

    /// As those of pairs that are kept from step to step often are.
    static bool are_in_order(const std::vector<Contact<S>>& contacts) {
        return std::is_sorted(contacts.begin(), contacts.end(),
                              [](const Contact<S>& a, const Contact<S>& b) { return ids_of(a) < ids_of(b); });
    }
    /// By comparing them: the work does not grow with the number of bodies.
    void sort_few(const std::vector<Contact<S>>& contacts, std::size_t found) {
        keys_.clear();
        for (std::size_t i = 0; i < found; ++i) keys_.push_back({ids_of(contacts[i]), std::uint32_t(i)});
        std::sort(keys_.begin(), keys_.end());
        sorted_.resize(found);
        for (std::size_t i = 0; i < found; ++i) sorted_[i] = contacts[keys_[i].place];
    }
    void sort_many(std::vector<Contact<S>>& contacts, std::size_t found, std::size_t ids) {
        begin_.assign(ids + 1, 0);
        for (std::size_t i = 0; i < found; ++i) ++begin_[contacts[i].first.id + 1];
        for (std::size_t id = 0; id < ids; ++id) begin_[id + 1] += begin_[id];
        sorted_.resize(found);
        next_.assign(begin_.begin(), begin_.end());
        bool many = false;
        for (std::size_t i = 0; i < found; ++i) {
            const auto& c = contacts[i];
            auto place = next_[c.first.id]++;
            if (begin_[c.first.id + 1] - begin_[c.first.id] > few) many = true;
            else
                for (; place > begin_[c.first.id] && c.second.id < sorted_[place - 1].second.id; --place)
                    sorted_[place] = sorted_[place - 1];
            sorted_[place] = c;
        }
        if (!many) return;
        for (std::size_t id = 0; id < ids; ++id)
            if (begin_[id + 1] - begin_[id] > few) sort_those_of_one(contacts, begin_[id], begin_[id + 1]);
    }
    /// The contacts of one body that has many, as the ground has: insertion would take the square of their number.
    /// \param spare contacts that are not needed any more
    void sort_those_of_one(std::vector<Contact<S>>& spare, std::size_t begin, std::size_t end) {
        keys_.clear();
        for (std::size_t i = begin; i < end; ++i) keys_.push_back({sorted_[i].second.id, std::uint32_t(i)});
        if (std::is_sorted(keys_.begin(), keys_.end())) return;
        std::sort(keys_.begin(), keys_.end());
        std::copy(sorted_.begin() + std::ptrdiff_t(begin), sorted_.begin() + std::ptrdiff_t(end),
                  spare.begin() + std::ptrdiff_t(begin));
        for (std::size_t i = begin; i < end; ++i) sorted_[i] = spare[keys_[i - begin].place];
    }
    /// The sorted contacts and those that were in order already; of one pair, the sorted ones come first.
    void merge(std::vector<Contact<S>>& contacts, std::size_t found) {
        std::size_t next = found, to = 0; // reading never falls behind writing
        for (const auto& c : sorted_) {
            for (; next < contacts.size() && ids_of(contacts[next]) < ids_of(c); ++next)
                contacts[to++] = contacts[next];
            contacts[to++] = c;
        }
    }

    std::vector<std::uint32_t> begin_, next_;
    std::vector<Key> keys_;
    std::vector<Contact<S>> sorted_;
};

namespace detail {

/// Which contacts are new, which go on, and which have ended. What happened in any substep is reported for the step.
/// \param known, found both in order; those found are told how long they have lasted
/// \param ended        pairs of handles, to which those that have ended are added
/// \param later        whether this is a substep and not the first
template <class S>
void compare_contacts(const std::vector<Contact<S>>& known, std::vector<Contact<S>>& found, auto& ended, bool later) {
    auto old = known.cbegin();
    auto before = [](const Contact<S>& x, const Contact<S>& y) {
        return std::pair(x.first.id, x.second.id) < std::pair(y.first.id, y.second.id);
    };
    for (auto& contact : found) {
        for (; old != known.cend() && before(*old, contact); ++old) ended.push_back({old->first, old->second});
        const bool same = old != known.cend() && old->first == contact.first && old->second == contact.second;
        contact.steps = !same ? 0 : later ? old->steps : old->steps + 1;
        if (old != known.cend() && !before(contact, *old)) {
            if (!same) ended.push_back({old->first, old->second});
            ++old;
        }
    }
    for (; old != known.cend(); ++old) ended.push_back({old->first, old->second});
}

/// Of contacts in order, one for each pair: that which stands first.
template <class S> void keep_the_first_of_each_pair(std::vector<Contact<S>>& contacts) {
    const auto same = [](const auto& x, const auto& y) { return x.first == y.first && x.second == y.second; };
    contacts.erase(std::unique(contacts.begin(), contacts.end(), same), contacts.end());
}

/// Leaves of the contacts that were found those of bodies that touch now: not those that may begin in the next step.
/// \tparam Presses whether what acts in it knows which contacts press, however little two are apart
/// \param acting   what a response keeps of them; in order, too
template <bool Presses, class S>
void keep_those_that_touch(std::vector<Contact<S>>& found, [[maybe_unused]] const auto& acting) {
    [[maybe_unused]] std::size_t next = 0;
    const auto only_near = [&](const Contact<S>& contact) {
        if (contact.depth.value() > typename S::Scalar(0)) return false;
        if constexpr (Presses) {
            const auto& all = acting.all;
            const auto ids = std::pair(contact.first.id, contact.second.id);
            while (next != all.size() && std::pair(all[next].a, all[next].b) < ids) ++next;
            return next == all.size() || std::pair(all[next].a, all[next].b) != ids ||
                   !(all[next].impulse > typename S::Scalar(0));
        } else return true;
    };
    std::size_t kept = 0; // not std::remove_if, which may ask in any order
    for (std::size_t n = 0; n < found.size(); ++n)
        if (!only_near(found[n])) {
            if (kept != n) found[kept] = found[n];
            ++kept;
        }
    found.resize(kept);
}

} // namespace detail
} // namespace ansatz
