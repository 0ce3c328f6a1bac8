// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What becomes of contacts where a step divides a body (a vertex of cloth splits): the new one has the contacts that
/// the other has, its share of their impulses, and is left alone by the other.
///
/// For both lie in each other as deep as they can, and to separate them would be a push from nowhere. So bodies that
/// were one do not collide with each other until one has been out of all that it was one with: `Siblings`.

#include <ansatz/collision/contact.hpp>
#include <ansatz/world/hash.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace ansatz {

/// Which bodies were one body before, by ids: rings, of which each body knows the next one, so that dividing one needs
/// no memory.
class Siblings {
public:
    /// Room for a body with this id, which has none.
    void make_room(std::uint32_t id) {
        while (next_.size() <= id) next_.push_back(std::uint32_t(next_.size()));
    }
    /// Room for so many bodies.
    void reserve(std::size_t n) { next_.reserve(n); }
    /// Room for what another holds, so that assigning it cannot fail.
    void make_room_for(const Siblings& other) { next_.reserve(other.next_.size()); }
    /// Whether any body has some.
    bool any() const { return count_ > 0; }
    /// Whether a body has some.
    [[gnu::always_inline]] bool has(std::uint32_t id) const { return next_[id] != id; }
    /// Whether two are.
    [[gnu::always_inline]] bool are(std::uint32_t a, std::uint32_t b) const { return has(a) && in_one_ring(a, b); }
    /// A body has been divided.
    void divided(std::uint32_t id, std::uint32_t part) {
        count_ += has(id) ? 1 : 2;
        next_[part] = std::exchange(next_[id], part);
    }
    /// A body has none any more.
    void leave(std::uint32_t id) {
        if (!has(id)) return;
        auto before = id;
        while (next_[before] != id) before = next_[before];
        next_[before] = std::exchange(next_[id], id);
        count_ -= has(before) ? 1 : 2;
    }
    /// Those that are out of all that they were one with have none any more.
    /// \param meet a function of two ids: whether they lie in each other
    template <class Meet> void part(Meet&& meet) {
        if (!any()) return;
        for (std::uint32_t id = 0; id < next_.size(); ++id) {
            bool lies = false;
            for (auto other = next_[id]; other != id && !lies; other = next_[other]) lies = meet(id, other);
            if (!lies) leave(id);
        }
    }
    /// Calls `f(id, next)` for each that has some, by id: what a file holds.
    template <class F> void each(F&& f) const {
        if (!any()) return;
        for (std::uint32_t id = 0; id < next_.size(); ++id)
            if (has(id)) f(id, next_[id]);
    }
    /// From a file.
    /// \param next of each body; a permutation
    void load(std::vector<std::uint32_t> next) {
        next_ = std::move(next);
        count_ = 0;
        for (std::uint32_t id = 0; id < next_.size(); ++id) count_ += has(id) ? 1 : 0;
    }
    /// Adds everything to a hash.
    void add_to(StateHash& hash) const {
        each([&](std::uint32_t id, std::uint32_t next) { hash.add(std::uint64_t(id) << 32 | next); });
    }

private:
    bool in_one_ring(std::uint32_t a, std::uint32_t b) const {
        auto other = next_[a];
        while (other != a && other != b) other = next_[other];
        return other == b;
    }

    std::vector<std::uint32_t> next_; // of each ring, by id; of itself where there is none
    std::size_t count_ = 0;           // bodies in rings
};

/// What the collisions of a world keep of it; nothing, where no step divides bodies.
/// \tparam Divides whether one does
template <bool Divides> class Division {
public:
    /// Whether two are left alone because they were one.
    [[gnu::always_inline]] bool were_one(std::uint32_t a, std::uint32_t b) const { return siblings_.are(a, b); }
    /// Adds which bodies were one to a hash.
    void add_siblings_to(StateHash& hash) const { siblings_.add_to(hash); }

protected:
    /// Those that are out of all that they were one with collide again.
    template <class Meet> void part_siblings(Meet&& meet) { siblings_.part(meet); }
    Siblings siblings_; ///< which bodies were one
};
/// The same, where none does.
template <> class Division<false> {
public:
    /// Nobody was.
    static constexpr bool were_one(std::uint32_t, std::uint32_t) { return false; }
    /// Nothing.
    static void add_siblings_to(StateHash&) {}

protected:
    /// Nothing.
    template <class Meet> static void part_siblings(Meet&&) {}
};

namespace detail {

/// Room for so many in each of some lists; what has none, or is not there, is left out.
template <class T> void reserve_one(std::size_t n, T& list) {
    if constexpr (requires { list.reserve(n); }) list.reserve(n);
    else if constexpr (requires { list->reserve(n); }) {
        if (list) list->reserve(n);
    }
}
template <class... T> void reserve_each(std::size_t n, T&... list) { (reserve_one(n, list), ...); }
/// Binds a broadphase.
/// \tparam Divides whether steps make bodies, for which it gets room
/// \param  n       for how many bodies there is room
template <bool Divides, class Finder>
void make_finder(std::optional<Finder>& finder, const auto& broadphase, [[maybe_unused]] std::size_t n) {
    finder.emplace(broadphase);
    if constexpr (Divides) reserve_one(n, *finder);
}
/// Room for what divided bodies take along: as much again as there is.
/// \param more how many may come to them before
template <class T> void make_room_for_copies(std::vector<T>& all, std::size_t more) {
    if (const auto n = all.size() + more; all.capacity() < 2 * n) all.reserve(4 * n);
}
/// Gives a body the contacts that another has, in their places among contacts in order.
/// \param from, to both bodies; they are in one place
template <class S> void copy_contacts(std::vector<Contact<S>>& contacts, Handle from, Handle to) {
    const auto ids = [](const Contact<S>& c) { return std::pair(c.first.id, c.second.id); };
    for (std::size_t i = 0, known = contacts.size(); i < known; ++i) {
        Contact<S> copy = contacts[i];
        if (!(copy.first == from) && !(copy.second == from)) continue;
        (copy.first == from ? copy.first : copy.second) = to;
        if (copy.second.id < copy.first.id) {
            std::swap(copy.first, copy.second);
            copy.normal = -copy.normal;
        }
        contacts.push_back(copy);
    }
    std::sort(contacts.begin(), contacts.end(),
              [&](const Contact<S>& x, const Contact<S>& y) { return ids(x) < ids(y); });
}

/// Gives a body its share of the impulses of another, in their places among constraints in order.
/// \param all   of contacts: two ids, a normal, an impulse along it, and one across it where they rub
/// \param share of the mass, and so of the load that they hold
template <bool Rubs, class Constraint, class Scalar>
void divide_impulses(std::vector<Constraint>& all, std::uint32_t id, std::uint32_t part, const Scalar& share) {
    const auto scale = [](Constraint& c, const Scalar& by) {
        c.impulse *= by;
        if constexpr (Rubs) c.rubbing *= by;
    };
    for (std::size_t n = 0, known = all.size(); n < known; ++n) {
        if (all[n].a != id && all[n].b != id) continue;
        Constraint copy = all[n];
        (copy.a == id ? copy.a : copy.b) = part;
        scale(copy, share);
        scale(all[n], Scalar(1) - share);
        if (copy.b < copy.a) {
            std::swap(copy.a, copy.b);
            copy.normal = -copy.normal;
            if constexpr (Rubs) copy.rubbing = -copy.rubbing;
        }
        all.push_back(copy);
    }
    std::sort(all.begin(), all.end(),
              [](const Constraint& x, const Constraint& y) { return std::pair(x.a, x.b) < std::pair(y.a, y.b); });
}

} // namespace detail
} // namespace ansatz
