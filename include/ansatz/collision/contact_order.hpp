// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `ContactOrder`: puts contacts in the order of their bodies' ids, so that sleeping, waking and the broadphase do not
/// decide in which order bodies are pushed; and what can be asked of contacts that stand so.
///
/// A counting sort by the first id, then the contacts of each by the second: the work grows with the contacts and
/// bodies, not with a logarithm of them, but where one body has many. Sorted are the ids and places of contacts, a
/// sixth of their size or less; then each contact is moved once. Those that are in order already, as those of sleeping
/// bodies are, are merged with the others and not sorted.

#include <ansatz/collision/contact.hpp>

#include <algorithm>
#include <cstddef>
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
        few_.reserve(ids / few_of);
    }
    /// Those of one pair stay as they stood to each other.
    /// \param ids     one more than the largest id
    /// \param ordered how many, at the end, are in order among themselves
    void sort(std::vector<Contact<S>>& contacts, std::size_t ids, std::size_t ordered = 0) {
        const std::size_t found = contacts.size() - ordered;
        if (order_.capacity() < contacts.capacity()) order_.reserve(contacts.capacity());
        if (ordered == 0 && are_in_order(contacts)) {
            reserve(ids); // for the first that are not
            return;
        }
        order_.resize(contacts.size());
        if (found < ids / few_of) few_.reserve(ids / few_of), sort_few(contacts, found);
        else sort_many(contacts, found, ids);
        if (ordered > 0) merge(contacts, found);
        move(contacts);
    }

private:
    /// Up to so many contacts of a body are put in order as they come.
    static constexpr std::size_t few = 16;
    /// Fewer contacts than this share of the bodies are sorted by comparing them.
    static constexpr std::size_t few_of = 8;
    template <class Ids> struct Key {
        Ids ids;             // or one of them
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
        few_.clear();
        for (std::size_t i = 0; i < found; ++i) few_.push_back({ids_of(contacts[i]), std::uint32_t(i)});
        std::sort(few_.begin(), few_.end());
        for (std::size_t i = 0; i < found; ++i) order_[i].place = few_[i].place;
    }
    void sort_many(const std::vector<Contact<S>>& contacts, std::size_t found, std::size_t ids) {
        begin_.assign(ids + 1, 0);
        for (std::size_t i = 0; i < found; ++i) ++begin_[contacts[i].first.id + 1];
        for (std::size_t id = 0; id < ids; ++id) begin_[id + 1] += begin_[id];
        for (std::size_t i = 0; i < found; ++i) {
            const auto& c = contacts[i];
            order_[begin_[c.first.id]++] = {c.second.id, std::uint32_t(i)};
        }
        std::size_t begin = 0; // `begin_[id]` is now where those of a body end
        for (std::size_t id = 0; id < ids; ++id) {
            sort_those_of_one(begin, begin_[id]);
            begin = begin_[id];
        }
    }
    /// The contacts of one body. Where it has many, as the ground has, insertion would take the square of their number.
    void sort_those_of_one(std::size_t begin, std::size_t end) {
        if (end - begin > few) {
            const auto at = [this](std::size_t n) { return order_.begin() + std::ptrdiff_t(n); };
            if (!std::is_sorted(at(begin), at(end))) std::sort(at(begin), at(end));
            return;
        }
        for (std::size_t i = begin + 1; i < end; ++i) {
            const auto key = order_[i];
            auto place = i;
            for (; place > begin && key.ids < order_[place - 1].ids; --place) order_[place] = order_[place - 1];
            order_[place] = key;
        }
    }
    /// The sorted contacts and those that were in order already; of one pair, the sorted ones come first.
    void merge(const std::vector<Contact<S>>& contacts, std::size_t found) {
        std::size_t next = contacts.size(), to = next; // from the last on: writing never comes to what is to be read
        for (std::size_t n = found; n > 0;) {
            const auto sorted = order_[--n];
            for (; next > found && !(ids_of(contacts[next - 1]) < ids_of(contacts[sorted.place])); --next)
                order_[--to].place = std::uint32_t(next - 1);
            order_[--to] = sorted;
        }
        while (to > 0) order_[--to].place = std::uint32_t(--next);
    }
    /// Each contact to where it belongs: the one that stands there is moved first, until one of them has made room for
    /// the last.
    void move(std::vector<Contact<S>>& contacts) {
        for (std::uint32_t first = 0; first < order_.size(); ++first) {
            if (order_[first].place == first) continue;
            const Contact<S> last = contacts[first];
            auto to = first;
            for (auto from = order_[to].place; from != first; from = order_[to].place) {
                contacts[to] = contacts[from];
                order_[to].place = to;
                to = from;
            }
            contacts[to] = last;
            order_[to].place = to;
        }
    }

    std::vector<std::uint32_t> begin_;
    std::vector<Key<std::uint32_t>> order_; // which contact belongs to each place, and its second id
    std::vector<Key<std::uint64_t>> few_;
};

namespace detail {

/// For `compare_contacts`: all that were found stay.
struct KeepAll {
    template <class S> bool operator()(const Contact<S>&, std::size_t) { return true; }
};
/// For `compare_contacts`: those of bodies that touch now stay, not those that may begin in the next step.
/// \tparam Presses whether what acts in it knows which contacts press, however little two are apart
/// \tparam Acting  what a response keeps of them; in order, too
template <bool Presses, class Acting> class KeepThoseThatTouch {
public:
    /// Of one step.
    explicit KeepThoseThatTouch(const Acting& acting) : acting_(acting) {}
    /// Of a contact and its number among those that were found; asked in their order.
    template <class S> bool operator()(const Contact<S>& contact, [[maybe_unused]] std::size_t n) {
        if (contact.depth.value() > typename S::Scalar(0)) return true;
        if constexpr (Presses) {
            const auto& all = acting_.all;
            const auto ids = ids_of(contact);
            if (n < all.size() && !(ids < ids_of(all[n])))
                next_ = std::max(next_, n); // mostly the same number: all have what was found, but for sensors
            while (next_ != all.size() && ids_of(all[next_]) < ids) ++next_;
            return next_ != all.size() && ids_of(all[next_]) == ids && all[next_].impulse > typename S::Scalar(0);
        } else return false;
    }

private:
    const Acting& acting_;
    std::size_t next_ = 0;
};

/// Which contacts are new, which go on, and which have ended. What happened in any substep is reported for the step.
/// \param known, found both in order; those found are told how long they have lasted
/// \param ended        pairs of handles, to which those that have ended are added
/// \param later        whether this is a substep and not the first
/// \param stays        of a contact and its number: those that were found and do not stay are left out
template <class S>
void compare_contacts(const std::vector<Contact<S>>& known, std::vector<Contact<S>>& found, auto& ended, bool later,
                      auto stays) {
    auto old = known.cbegin();
    std::size_t kept = 0;
    for (std::size_t n = 0; n < found.size(); ++n) {
        if (!stays(found[n], n)) continue;
        auto& contact = found[kept++];
        if (kept != n + 1) contact = found[n];
        const auto ids = ids_of(contact);
        for (; old != known.cend() && ids_of(*old) < ids; ++old) ended.push_back({old->first, old->second});
        const bool same = old != known.cend() && old->first == contact.first && old->second == contact.second;
        contact.steps = !same ? 0 : later ? old->steps : old->steps + 1;
        if (old != known.cend() && !(ids < ids_of(*old))) {
            if (!same) ended.push_back({old->first, old->second});
            ++old;
        }
    }
    found.resize(kept);
    for (; old != known.cend(); ++old) ended.push_back({old->first, old->second});
}

/// Of contacts in order, one for each pair: that which stands first.
template <class S> void keep_the_first_of_each_pair(std::vector<Contact<S>>& contacts) {
    const auto same = [](const auto& x, const auto& y) { return x.first == y.first && x.second == y.second; };
    contacts.erase(std::unique(contacts.begin(), contacts.end(), same), contacts.end());
}

} // namespace detail
} // namespace ansatz
