// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `SleepingContacts`: contacts of bodies that sleep, apart from those that act (notes 1.1: nothing is computed for
/// what rests). They stay as they are until something that they hold wakes, and no step goes through them.
///
/// `ContactLists`: the contacts of a world in these two lists, and as one where somebody asks for them.

#include <ansatz/collision/contact.hpp>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace ansatz {

namespace detail {
/// The bodies of what is kept of a pair: by these pairs are in order.
template <class T> [[gnu::always_inline]] inline std::pair<std::uint32_t, std::uint32_t> ids_of(const T& pair) {
    if constexpr (requires { pair.first.id; }) return {pair.first.id, pair.second.id};
    else return {pair.a, pair.b};
}
} // namespace detail

/// Pairs of sleeping bodies, in the order of their ids.
/// \tparam T a pair: a contact, or what a response keeps of one
template <class T> class SleepingContacts {
public:
    /// Whether there are none.
    bool empty() const { return all_.empty(); }
    /// How many.
    std::size_t size() const { return all_.size(); }
    /// All of them.
    const std::vector<T>& all() const { return all_; }
    /// Room for what another holds, so that assigning it cannot fail.
    void make_room_for(const SleepingContacts& other) { all_.reserve(other.size()); }

    /// Takes pairs out of those that act. With room for them in `make_room`, it cannot fail.
    /// \param sleeps a function of a pair: whether neither of its bodies moves
    void take(std::vector<T>& acting, const auto& sleeps) {
        std::size_t from = all_.size(), to = from + std::size_t(std::ranges::count_if(acting, sleeps));
        all_.resize(to);
        for (std::size_t n = acting.size(); n-- > 0;) {
            if (!sleeps(acting[n])) continue;
            while (from > 0 && detail::ids_of(acting[n]) < detail::ids_of(all_[from - 1])) all_[--to] = all_[--from];
            all_[--to] = acting[n];
        }
        std::erase_if(acting, sleeps);
    }
    /// Room for so many more.
    void make_room(std::size_t n) {
        if (all_.capacity() < all_.size() + n) all_.reserve(std::max(all_.size() + n, 2 * all_.capacity()));
    }
    /// All pairs act again. With room for them in `acting`, it cannot fail.
    void wake(std::vector<T>& acting) {
        std::size_t from = acting.size(), left = all_.size(), to = from + left;
        acting.resize(to);
        while (left > 0)
            if (from > 0 && detail::ids_of(all_[left - 1]) < detail::ids_of(acting[from - 1]))
                acting[--to] = acting[--from];
            else acting[--to] = all_[--left];
        all_.clear();
    }
    /// Calls `f(pair)` for those that act and those that sleep, in the order of their ids.
    void each(const std::vector<T>& acting, auto&& f) const {
        auto asleep = all_.cbegin();
        for (const T& pair : acting) {
            for (; asleep != all_.cend() && detail::ids_of(*asleep) < detail::ids_of(pair); ++asleep) f(*asleep);
            f(pair);
        }
        for (; asleep != all_.cend(); ++asleep) f(*asleep);
    }
    /// Calls `f(pair)` for each, which it may change but for its ids.
    void change_each(auto&& f) {
        for (T& pair : all_) f(pair);
    }
    /// A body has been removed, and its pairs with it.
    void forget(std::uint32_t id) {
        std::erase_if(all_, [id](const T& pair) {
            const auto ids = detail::ids_of(pair);
            return ids.first == id || ids.second == id;
        });
    }

private:
    std::vector<T> all_;
};

namespace detail {
/// All contacts in one list, made for the first that asks; several threads may ask at once. Its room is kept.
template <class S> class JoinedContacts {
public:
    using List = std::vector<Contact<S>>;
    JoinedContacts() = default;
    JoinedContacts(const JoinedContacts&) noexcept {}
    JoinedContacts& operator=(const JoinedContacts&) noexcept {
        forget();
        return *this;
    }
    ~JoinedContacts() {
        delete made_.load();
        delete spare_.load();
    }
    /// Something has changed.
    void forget() {
        if (made_.load(std::memory_order_relaxed)) delete spare_.exchange(made_.exchange(nullptr));
    }
    /// \param fill a function of the list, which is empty
    const List& get(const auto& fill) const {
        if (const List* there = made_.load()) return *there;
        Mine mine{spare_.exchange(nullptr)};
        if (!mine.list) mine.list = new List;
        mine.list->clear();
        fill(*mine.list);
        List* none = nullptr;
        if (made_.compare_exchange_strong(none, mine.list)) return *std::exchange(mine.list, nullptr);
        return *none;
    }

private:
    struct Mine {
        List* list;
        ~Mine() { delete list; }
    };
    mutable std::atomic<List*> made_{nullptr}, spare_{nullptr};
};
} // namespace detail

/// The contacts of a world, by the ids of their bodies.
template <class S> class ContactLists {
public:
    /// Those that a step goes through: a body of them may move, or has fallen asleep in the last step.
    std::vector<Contact<S>> acting;

    /// Whether some are kept apart, because their bodies sleep.
    bool any_sleep() const { return !asleep_.empty(); }
    /// Acting and sleeping ones; asked for once or a hundred times in a step, they are put together once.
    const std::vector<Contact<S>>& all() const {
        if (asleep_.empty()) return acting;
        return joined_.get([&](auto& list) {
            list.reserve(acting.size() + asleep_.size());
            const Contact<S>* first = asleep_.all().data();
            asleep_.each(acting, [&](const Contact<S>& c) {
                list.push_back(c);
                if (&c >= first && &c < first + asleep_.size()) list.back().steps += steps_;
            });
        });
    }
    /// Whether two bodies are in contact; the one with the smaller id first.
    bool has(std::uint32_t a, std::uint32_t b) const {
        const auto in = [&](const std::vector<Contact<S>>& list) {
            const auto at = std::lower_bound(list.begin(), list.end(), std::pair(a, b),
                                             [](const auto& c, const auto& ids) { return detail::ids_of(c) < ids; });
            return at != list.end() && detail::ids_of(*at) == std::pair(a, b);
        };
        return in(acting) || in(asleep_.all());
    }
    /// A step is done: those that sleep have lasted one more.
    void sleep_on() {
        ++steps_;
        changed();
    }
    /// Those that act are others now.
    void changed() { joined_.forget(); }
    /// Room for those that sleep among those that act, and back.
    void make_room_to_wake() {
        if (acting.capacity() < acting.size() + asleep_.size()) acting.reserve(acting.size() + asleep_.size());
    }
    /// All act. With room for them, it cannot fail.
    void wake() {
        asleep_.change_each([&](auto& c) { c.steps += steps_; });
        asleep_.wake(acting);
        changed();
    }
    /// Room for so many that fall asleep.
    void make_room_to_sleep(std::size_t n) { asleep_.make_room(n); }
    /// Those for which `sleeps` holds are kept apart. With room for them, it cannot fail.
    void put_to_sleep(const auto& sleeps) {
        for (auto& c : acting)
            if (sleeps(c)) c.steps -= steps_; // counts round where it has lasted less: it is added again
        asleep_.take(acting, sleeps);
        changed();
    }
    /// Room for what another holds, so that assigning it cannot fail.
    void make_room_for(const ContactLists& other) {
        acting.reserve(other.acting.size());
        asleep_.make_room_for(other.asleep_);
    }

private:
    SleepingContacts<Contact<S>> asleep_; // how many steps each has lasted is counted without `steps_`
    std::uint32_t steps_ = 0;             // in which some have slept
    detail::JoinedContacts<S> joined_;
};

} // namespace ansatz
