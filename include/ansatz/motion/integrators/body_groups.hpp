// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `BodyGroups`: the bodies of a system in groups of neighbours, for a solver that also moves each group as a whole
/// (group_correction.hpp). Beyond the notes.
// not in the umbrella: only worlds that couple bodies and solve by MatrixFree need it
///
/// A group grows from one body to its neighbours, to theirs, and so on, so that it is as compact as what couples them
/// lets it be. A remainder that is too small for a group joins one beside it. Bodies that nothing couples, or only few
/// others, are in no group. The groups depend on nothing but the pairs, in their order.

#include <ansatz/core/compiler_flags.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ansatz {

/// Which body belongs to which group.
class BodyGroups {
public:
    static constexpr std::uint32_t none = 0xffffffffu; ///< the group of a body that is in no group
    static constexpr std::size_t fewest = 16;          ///< bodies of a group

    /// Room for so many bodies.
    void reserve(std::size_t bodies) {
        group_.reserve(bodies);
        order_.reserve(bodies);
        first_.reserve(bodies + 1);
        sizes_.reserve(bodies);
    }
    /// Makes the groups.
    /// \param bodies    how many there are
    /// \param each_pair calls a function with the two bodies of each pair, and does so again in the same order
    void make(std::size_t bodies, const auto& each_pair) {
        list_neighbours(bodies, each_pair);
        group_.assign(bodies, none);
        sizes_.clear();
        order_.clear();
        border_.reserve(neighbours_.capacity()); // all that may come to stand there
        const std::size_t wanted = wanted_size(bodies);
        for (std::uint32_t body = 0; body < bodies; ++body) {
            if (group_[body] != none || degree(body) == 0) continue;
            border_.clear();
            border_.push_back(body);
            for (std::size_t next = 0; next < border_.size(); ++next)
                if (group_[border_[next]] == none) grow(border_[next], wanted);
        }
        for (auto& group : group_)
            if (group == apart) group = none;
    }
    /// How many groups there are.
    std::size_t size() const { return sizes_.size(); }
    /// The group of a body, or `none`.
    std::uint32_t of(std::size_t body) const { return group_[body]; }

private:
    static constexpr std::uint32_t apart = none - 1; // while they are made: of a body in too small a component

    std::size_t degree(std::size_t body) const { return first_[body + 1] - first_[body]; }
    /// Half the root of the number of bodies that are coupled, so that solving for the groups costs less than
    /// multiplying with the matrix; with smaller ones iterations are fewer but each costs more (of conjugate gradients
    /// to 1e-10, a sheet of 100 x 100: 138 with groups of 25, 171 of 50, 216 of 100). No less than what pays in systems
    /// of hundreds.
    std::size_t wanted_size(std::size_t bodies) const {
        std::size_t coupled = 0;
        for (std::size_t body = 0; body < bodies; ++body) coupled += degree(body) > 0;
        return std::max(2 * fewest, std::size_t(std::sqrt(double(coupled)) / 2));
    }
    void list_neighbours(std::size_t bodies, const auto& each_pair) {
        first_.assign(bodies + 1, 0);
        each_pair([&](std::size_t a, std::size_t b) { ++first_[a], ++first_[b]; });
        std::uint32_t end = 0;
        for (auto& first : first_) first = end += first; // behind the last neighbour; filling them goes down
        if (neighbours_.capacity() < end) neighbours_.reserve(2 * std::size_t(end)); // for pairs that come
        neighbours_.resize(end);
        each_pair([&](std::size_t a, std::size_t b) {
            neighbours_[--first_[a]] = std::uint32_t(b);
            neighbours_[--first_[b]] = std::uint32_t(a);
        });
    }
    /// A group around a body that is in none. What it touches is put on the border.
    void grow(std::uint32_t seed, std::size_t wanted) {
        const auto mine = std::uint32_t(sizes_.size());
        const std::size_t begin = order_.size();
        std::uint32_t beside = none; // the smallest group that it touches
        const auto take = [&](std::uint32_t body) {
            group_[body] = mine;
            order_.push_back(body);
        };
        take(seed);
        for (std::size_t at = begin; at < order_.size(); ++at)
            for (std::uint32_t k = first_[order_[at]]; k < first_[order_[at] + 1]; ++k) {
                const std::uint32_t body = neighbours_[k], theirs = group_[body];
                if (theirs == mine) continue;
                if (theirs == none) {
                    if (order_.size() - begin < wanted) take(body);
                    else border_.push_back(body);
                } else if (beside == none || sizes_[theirs] < sizes_[beside]) beside = theirs;
            }
        const std::size_t count = order_.size() - begin;
        if (2 * count >= wanted) return sizes_.push_back(count);
        for (std::size_t at = begin; at < order_.size(); ++at) group_[order_[at]] = beside == none ? apart : beside;
        if (beside != none) sizes_[beside] += count;
    }

    std::vector<std::uint32_t> group_;      // of each body
    std::vector<std::size_t> sizes_;        // of each group
    std::vector<std::uint32_t> first_;      // where the neighbours of a body begin
    std::vector<std::uint32_t> neighbours_; // of all bodies
    std::vector<std::uint32_t> order_;      // bodies as they were taken
    std::vector<std::uint32_t> border_;     // bodies beside groups; some are in one meanwhile
};

} // namespace ansatz
