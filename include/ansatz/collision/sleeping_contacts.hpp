// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `SleepingContacts`: contacts of bodies that sleep, apart from those that act (notes 1.1: nothing is computed for
/// what rests). They stay as they are until a body of them wakes, and no step goes through them. Those of one body are
/// found without visiting the others, so that waking a pile costs what the pile is.

#include <ansatz/collision/contact.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace ansatz {

namespace detail {
/// A list that is made when it is first asked for; several threads may ask at once. Its room is kept.
template <class T> class MadeWhenAsked {
public:
    using List = std::vector<T>;
    MadeWhenAsked() = default;
    MadeWhenAsked(const MadeWhenAsked&) noexcept {}
    MadeWhenAsked& operator=(const MadeWhenAsked&) noexcept {
        forget();
        return *this;
    }
    ~MadeWhenAsked() {
        delete made_.load();
        delete spare_.load();
    }
    /// Marks the list as out of date.
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

/// Pairs of sleeping bodies.
/// \tparam T a pair: a contact, or what a response keeps of one
template <class T> class SleepingContacts {
public:
    /// Whether there are none.
    bool empty() const { return marks_.count == 0; }
    /// How many.
    std::size_t size() const { return marks_.count; }
    /// One of them, by its place.
    const T& operator[](std::uint32_t place) const { return nodes_[place].pair; }

    /// Room for so many more, and for bodies with ids below `ids`.
    void make_room(std::size_t n, std::size_t ids) {
        if (const auto needed = marks_.count + n; nodes_.capacity() < needed)
            nodes_.reserve(std::max(needed, 2 * nodes_.capacity()));
        if (first_.size() < ids) first_.resize(ids, none);
    }
    /// Room for the contents of another, so that assigning it cannot fail.
    void make_room_for(const SleepingContacts& other) {
        nodes_.reserve(other.nodes_.size());
        first_.reserve(other.first_.size());
    }
    /// Takes pairs out of the acting ones. With room for them in `make_room`, it cannot fail.
    /// \param sleeps a function of a pair: whether neither of its bodies moves
    void take(std::vector<T>& acting, const auto& sleeps) {
        std::erase_if(acting, [&](const T& pair) {
            if (!sleeps(pair)) return false;
            add(pair);
            return true;
        });
        in_order_.forget();
    }

    /// \name Pairs that act again: those of some bodies leave, then all that have left are merged
    /// @{
    /// Room for all to leave.
    void make_room_to_leave() { order_.reserve(marks_.count); }
    /// The pairs of a body leave. They stay here until they are merged, but belong to no body. It cannot fail.
    /// \param f is called with the place of each
    void leave(std::uint32_t id, auto&& f) {
        each_place_of(id, [&](std::uint32_t place, std::size_t side) {
            unlink(place, 1 - side);
            nodes_[place].next[0] = std::exchange(marks_.left, place);
            f(place);
        });
        if (id < first_.size()) first_[id] = none;
    }
    /// Whether any has left.
    bool any_left() const { return marks_.left != none; }
    /// Those that have left, in the order of their ids. With room for them, it cannot fail.
    const std::vector<std::uint32_t>& left() {
        order_.clear();
        for (auto place = marks_.left; place != none; place = nodes_[place].next[0]) order_.push_back(place);
        std::sort(order_.begin(), order_.end(), [this](std::uint32_t a, std::uint32_t b) {
            return detail::ids_of(nodes_[a].pair) < detail::ids_of(nodes_[b].pair);
        });
        return order_;
    }
    /// Merges them with the acting pairs. With room for them, it cannot fail.
    /// \param as what to make of each
    void merge(std::vector<T>& acting, const auto& as) {
        if (!any_left()) return;
        std::size_t from = acting.size(), to = from + left().size();
        acting.resize(to);
        for (auto place = order_.rbegin(); place != order_.rend(); ++place) {
            const T& pair = nodes_[*place].pair;
            while (from > 0 && detail::ids_of(pair) < detail::ids_of(acting[from - 1])) acting[--to] = acting[--from];
            acting[--to] = as(pair);
            release(*place);
        }
        marks_.left = none;
        order_.clear();
        in_order_.forget();
    }
    /// @}

    /// A body has been removed, and its pairs with it.
    void forget(std::uint32_t id) {
        each_place_of(id, [&](std::uint32_t place, std::size_t side) {
            unlink(place, 1 - side);
            release(place);
        });
        if (id < first_.size()) first_[id] = none;
        in_order_.forget();
    }
    /// Whether any pair has this body.
    bool has(std::uint32_t id) const { return id < first_.size() && first_[id] != none; }
    /// Whether there is a pair of these two, the one with the smaller id first. The lists of both are gone through side
    /// by side: the ground's may be long.
    bool has(std::uint32_t a, std::uint32_t b) const {
        if (!has(a) || !has(b)) return false;
        const auto is = [&](std::uint32_t edge) { return detail::ids_of(nodes_[edge / 2].pair) == std::pair(a, b); };
        auto of_a = first_[a], of_b = first_[b];
        for (; of_a != none && of_b != none; of_a = next(of_a), of_b = next(of_b))
            if (is(of_a) || is(of_b)) return true;
        return false;
    }
    /// Calls `f(pair)` for those of a body, in any order.
    void each_of(std::uint32_t id, auto&& f) const {
        if (!has(id)) return;
        for (auto edge = first_[id]; edge != none; edge = next(edge)) f(nodes_[edge / 2].pair);
    }
    /// In the order of their ids, calls `act(pair)` for those that act, and `sleep(pair)` for those here.
    void each(const std::vector<T>& acting, auto&& act, auto&& sleep) const {
        const auto& order = in_order();
        auto here = order.cbegin();
        for (const T& pair : acting) {
            for (; here != order.cend() && here->ids < detail::ids_of(pair); ++here) sleep(nodes_[here->place].pair);
            act(pair);
        }
        for (; here != order.cend(); ++here) sleep(nodes_[here->place].pair);
    }

private:
    static constexpr std::uint32_t none = 0xffffffffu, unused = none - 1;
    /// A pair in the lists of its two bodies. An edge is a node and a side of it: 2 place + side.
    struct Node {
        T pair;
        std::array<std::uint32_t, 2> next, previous; // edges
    };
    /// Moved from, they are those of an empty list.
    struct Marks {
        std::uint32_t left = none; // the place of a pair that has left; `next` names another
        std::uint32_t free = none; // a place without a pair; `previous` names another
        std::size_t count = 0;
        Marks() = default;
        Marks(const Marks&) = default;
        Marks(Marks&& other) noexcept { *this = std::move(other); }
        Marks& operator=(const Marks&) = default;
        Marks& operator=(Marks&& other) noexcept {
            left = std::exchange(other.left, none);
            free = std::exchange(other.free, none);
            count = std::exchange(other.count, 0);
            return *this;
        }
    };
    struct Place {
        std::pair<std::uint32_t, std::uint32_t> ids;
        std::uint32_t place;
    };

    std::uint32_t body_of(std::uint32_t place, std::size_t side) const {
        const auto ids = detail::ids_of(nodes_[place].pair);
        return side == 0 ? ids.first : ids.second;
    }
    std::uint32_t next(std::uint32_t edge) const { return nodes_[edge / 2].next[edge % 2]; }
    void add(const T& pair) {
        auto place = std::uint32_t(nodes_.size());
        if (marks_.free == none) nodes_.push_back({pair, {}, {}});
        else {
            place = marks_.free;
            marks_.free = nodes_[place].previous[0];
            nodes_[place].pair = pair;
        }
        ++marks_.count;
        for (const std::size_t side : {0u, 1u}) {
            const auto edge = std::uint32_t(2 * std::size_t(place) + side);
            auto& first = first_[body_of(place, side)];
            nodes_[place].next[side] = first;
            nodes_[place].previous[side] = none;
            if (first != none) nodes_[first / 2].previous[first % 2] = edge;
            first = edge;
        }
    }
    /// Takes a pair out of the list of one of its bodies.
    void unlink(std::uint32_t place, std::size_t side) {
        const auto before = nodes_[place].previous[side], after = nodes_[place].next[side];
        if (after != none) nodes_[after / 2].previous[after % 2] = before;
        (before != none ? nodes_[before / 2].next[before % 2] : first_[body_of(place, side)]) = after;
    }
    /// Its place is given to another pair.
    void release(std::uint32_t place) {
        nodes_[place].next[0] = unused;
        nodes_[place].previous[0] = std::exchange(marks_.free, place);
        if (--marks_.count > 0) return;
        nodes_.clear();
        marks_.free = none;
    }
    /// Calls `f(place, side)` for the pairs of a body, which may leave meanwhile.
    void each_place_of(std::uint32_t id, auto&& f) {
        if (!has(id)) return;
        for (auto edge = first_[id]; edge != none;) {
            const auto now = std::exchange(edge, next(edge));
            f(now / 2, now % 2);
        }
    }
    const std::vector<Place>& in_order() const {
        return in_order_.get([this](std::vector<Place>& order) {
            for (std::uint32_t place = 0; place < nodes_.size(); ++place)
                if (nodes_[place].next[0] != unused) order.push_back({detail::ids_of(nodes_[place].pair), place});
            std::sort(order.begin(), order.end(), [](const Place& a, const Place& b) { return a.ids < b.ids; });
        });
    }

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> first_; // by id: an edge of the body
    std::vector<std::uint32_t> order_; // of those that have left
    Marks marks_;
    detail::MadeWhenAsked<Place> in_order_;
};

} // namespace ansatz
