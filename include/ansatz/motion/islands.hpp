// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Islands`: which bodies hang together, by contacts or springs, so that they fall asleep and wake together
/// (notes 1.8).
///
/// A pile of which one body sleeps and the next does not would wake it again and again. What is fixed joins nothing:
/// two piles on one ground are two islands.
///
/// `SleepScratch` is what a world keeps to find the bodies that fall asleep (sleep.hpp).
///
/// R. E. Tarjan, Efficiency of a good but not linear set union algorithm (1975).

#include <ansatz/core/compiler_flags.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ansatz {

/// Sets of numbers below n that are united two by two.
class Islands {
public:
    /// Room for so many numbers.
    void reserve(std::size_t n) { parent_.reserve(n); }
    /// n islands of one each.
    void reset(std::size_t n) {
        parent_.resize(n);
        for (std::uint32_t i = 0; i < n; ++i) parent_[i] = i;
    }
    /// The number of the island of `i`.
    std::uint32_t of(std::uint32_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]]; // each search makes the next one shorter
        return i;
    }
    /// Joins two islands. The smaller number is kept, so that the order of the calls does not matter.
    void unite(std::uint32_t i, std::uint32_t j) {
        i = of(i);
        j = of(j);
        if (i < j) parent_[j] = i;
        else parent_[i] = j;
    }

private:
    std::vector<std::uint32_t> parent_;
};

/// What is kept from step to step to find the bodies that fall asleep (sleep.hpp).
template <class S> struct SleepScratch {
    Islands islands; ///< of the awake bodies, by slot
    /// By slot: what accelerates a body that stands still, contacts included where their push is known.
    std::vector<typename S::Acceleration> pulls;
    /// By slot: how much of it may remain where contacts carry.
    std::vector<decltype(norm(typename S::Acceleration()))> trembles;
    std::vector<std::uint8_t> held;         ///< by slot: whether something holds the body
    std::vector<std::uint8_t> goes_along;   ///< by slot: whether it touches a platform that moves, or hangs on one
    std::vector<std::uint8_t> restless;     ///< whether an island stays awake, by its root
    std::vector<std::uint32_t> sleepers;    ///< by id
    std::vector<typename S::Scalar> struck; ///< by slot: how fast a body may be that is struck in this substep, m/s

    /// Nothing holds the awake ones; others are not asked.
    void forget_held(std::size_t bodies, std::size_t awake) {
        if (held.size() < bodies) held.resize(bodies);
        std::fill_n(held.begin(), awake, std::uint8_t(0));
    }
    /// Room for so many bodies.
    void reserve(std::size_t n) {
        islands.reserve(n);
        pulls.reserve(n);
        trembles.reserve(n);
        held.reserve(n);
        goes_along.reserve(n);
        restless.reserve(n);
        sleepers.reserve(n);
        struck.reserve(n);
    }
};

} // namespace ansatz
