// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `NamedBy`: which elements name a body, so that removing the body costs a visit of its own elements and not of all.
///
/// A cache of a table of elements. It is found when the first body is removed, for all bodies at once, and lasts while
/// bodies and elements go; elements that are added are kept in a short list beside it, and when that is full, the next
/// removal finds all anew. So n removals cost n steps and not n squared, a table from which no body is ever removed
/// pays nothing, and neither copy nor file holds any of it.

#include <ansatz/core/compiler_flags.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ansatz::detail {

class NamedBy {
public:
    NamedBy() = default;
    NamedBy(const NamedBy&) noexcept {} // a copy finds its own
    NamedBy(NamedBy&&) noexcept = default;
    NamedBy& operator=(const NamedBy&) noexcept {
        known_ = false;
        return *this;
    }
    NamedBy& operator=(NamedBy&&) noexcept = default;
    ~NamedBy() = default;

    /// Room for so many bodies, if it was ever asked for.
    void reserve(std::size_t bodies) {
        if (!first_.empty()) first_.reserve(bodies + 1);
    }
    /// Whether `each` may be asked.
    bool known() const { return known_; }
    /// Finds it, unless it is known. This may fail, and what follows cannot.
    /// \param table  has `for_each(f)` by id, and `for_each_body(id, f)`
    /// \param bodies one more than the largest id of a body
    template <class Table> void find(const Table& table, std::size_t bodies) {
        if (known_) return;
        first_.assign(bodies + 1, 0);
        std::size_t all = 0;
        table.for_each([&](std::uint32_t id, const auto&) {
            table.for_each_body(id, [&](std::uint32_t body) {
                ++first_[body];
                ++all;
            });
        });
        elements_.resize(all);
        added_.clear();
        added_.reserve(32 + std::size_t(std::sqrt(double(all))));
        std::size_t sum = 0;
        for (auto& first : first_) first = std::uint32_t(sum += first); // where those of a body end
        // From the last to the first, so that where they end becomes where they begin, and they lie by id.
        table.for_each_backwards([&](std::uint32_t id) {
            table.for_each_body(id, [&](std::uint32_t body) { elements_[--first_[body]] = id; });
        });
        known_ = true;
    }
    /// An element was added, or names other bodies now.
    void note(std::uint32_t id) {
        if (!known_) return;
        const auto place = std::lower_bound(added_.begin(), added_.end(), id);
        if (place != added_.end() && *place == id) return;
        if (added_.size() == added_.capacity()) known_ = false;
        else added_.insert(place, id);
    }
    /// Calls `f(id)` by id for each element that named the body when all were found, or was added since: it may be
    /// gone, or name others.
    template <class F> void each(std::uint32_t body, F&& f) const {
        const bool old = std::size_t(body) + 1 < first_.size();
        auto one = elements_.begin() + (old ? first_[body] : 0);
        const auto end = elements_.begin() + (old ? first_[body + 1] : 0);
        auto added = added_.begin();
        while (one != end || added != added_.end()) {
            const auto id = added == added_.end() || (one != end && *one < *added) ? *one : *added;
            while (one != end && *one == id) ++one;
            if (added != added_.end() && *added == id) ++added;
            f(id);
        }
    }

private:
    bool known_ = false;
    std::vector<std::uint32_t> first_;    // by body: where its elements begin; the last one's end behind them
    std::vector<std::uint32_t> elements_; // by body, then by id
    std::vector<std::uint32_t> added_;    // since then, by id
};

} // namespace ansatz::detail
