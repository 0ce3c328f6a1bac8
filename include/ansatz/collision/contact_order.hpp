// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `ContactOrder`: puts contacts in the order of their bodies' ids, so that sleeping, waking and the broadphase do not
/// decide in which order bodies are pushed; and what can be asked of contacts that stand so.
///
/// A counting sort by the first id, then each of its few contacts by the second: the work grows with the contacts and
/// bodies, not with a logarithm of them.

#include <ansatz/collision/contact.hpp>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace ansatz {

/// Sorts contacts; keeps the room that it needs.
template <class S> class ContactOrder {
public:
    /// Room for so many ids.
    void reserve(std::size_t ids) {
        begin_.reserve(ids + 1);
        next_.reserve(ids + 1);
    }
    /// \param ids one more than the largest id
    void sort(std::vector<Contact<S>>& contacts, std::size_t ids) {
        begin_.assign(ids + 1, 0);
        for (const auto& c : contacts) ++begin_[c.first.id + 1];
        for (std::size_t id = 0; id < ids; ++id) begin_[id + 1] += begin_[id];
        sorted_.resize(contacts.size());
        next_.assign(begin_.begin(), begin_.end());
        for (const auto& c : contacts) {
            auto place = next_[c.first.id]++;
            for (; place > begin_[c.first.id] && c.second.id < sorted_[place - 1].second.id; --place)
                sorted_[place] = sorted_[place - 1];
            sorted_[place] = c;
        }
        contacts.swap(sorted_);
    }

private:
    std::vector<std::uint32_t> begin_, next_;
    std::vector<Contact<S>> sorted_;
};

namespace detail {

/// Whether two bodies are among contacts in order; the one with the smaller id first.
template <class S> bool has_contact(const std::vector<Contact<S>>& contacts, std::uint32_t a, std::uint32_t b) {
    const auto at =
        std::lower_bound(contacts.begin(), contacts.end(), std::pair(a, b),
                         [](const Contact<S>& c, const auto& ids) { return std::pair(c.first.id, c.second.id) < ids; });
    return at != contacts.end() && at->first.id == a && at->second.id == b;
}

/// Which contacts are new, which go on, and which have ended. What happened in any part of a step is news of that step.
/// \param known, found both in order; those found are told how long they have lasted
/// \param ended        pairs of handles, to which those that have ended are added
/// \param later        whether this is a part of a step and not the first
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

} // namespace detail
} // namespace ansatz
