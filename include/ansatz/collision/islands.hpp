// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Islands`: which bodies hang together, by contacts or springs, so that they fall asleep and wake together (notes 1.8).
///
/// A pile of which one body sleeps and the next does not would wake it again and again. What is fixed joins nothing: two
/// piles on one ground are two islands.
///
/// R. E. Tarjan, Efficiency of a good but not linear set union algorithm (1975).

#include <cstdint>
#include <numeric>
#include <vector>

namespace ansatz {

/// Sets of numbers below n that are united two by two.
class Islands {
public:
    /// n islands of one each.
    void reset(std::size_t n) {
        parent_.resize(n);
        std::iota(parent_.begin(), parent_.end(), 0u);
    }
    /// The number that stands for the island of `i`.
    std::uint32_t of(std::uint32_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]]; // each look makes the next one shorter
        return i;
    }
    /// Makes one island of two. The smallest number stands for it, so that the order of the calls does not matter.
    void unite(std::uint32_t i, std::uint32_t j) {
        i = of(i);
        j = of(j);
        if (i < j) parent_[j] = i;
        else parent_[i] = j;
    }

private:
    std::vector<std::uint32_t> parent_;
};

} // namespace ansatz
