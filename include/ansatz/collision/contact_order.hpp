// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `ContactOrder`: puts contacts in the order of their bodies' ids, so that sleeping, waking and the broadphase do not decide
/// in which order bodies are pushed.
///
/// A counting sort by the first id, then each of its few contacts by the second: the work grows with the contacts and bodies,
/// not with a logarithm of them.

#include <ansatz/collision/contact.hpp>

#include <cstdint>
#include <vector>

namespace ansatz {

/// Sorts contacts; keeps the room that it needs.
template <class S> class ContactOrder {
public:
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

} // namespace ansatz
