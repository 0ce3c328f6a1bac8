// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// How often something allocates, and what is left where it finds no memory. One file of the program includes
/// tests/operator_new.hpp.

#include "tests/before_allocation.hpp"

#include <cstddef>
#include <new>

namespace fuzz {

inline std::size_t allocations = 0;
template <class F> std::size_t allocations_of(F&& f) {
    allocations = 0;
    ansatz::test::before_allocation = [](std::size_t) noexcept { return ++allocations > 0; };
    try {
        f();
    } catch (...) {
        ansatz::test::before_allocation = nullptr;
        throw;
    }
    ansatz::test::before_allocation = nullptr;
    return allocations;
}

inline std::size_t granted = 0;
/// Does something that is granted n allocations.
/// \return whether those were enough
template <class F> bool done_with(std::size_t n, F&& f) {
    granted = n;
    ansatz::test::before_allocation = [](std::size_t) noexcept { return granted > 0 && granted-- > 0; };
    bool enough = true;
    try {
        f();
    } catch (const std::bad_alloc&) {
        enough = false;
    } catch (...) {
        ansatz::test::before_allocation = nullptr;
        throw;
    }
    ansatz::test::before_allocation = nullptr;
    return enough;
}
/// Does something to copies of a world: to the first with no allocation, to the next with one, and so on, until that is
/// enough. A copy has no more room than it needs.
/// \return whether each that found no memory is as it was
template <class World, class F> bool is_whole_without_memory(const World& world, F&& verb) {
    for (std::size_t n = 0;; ++n) {
        auto copy = world;
        const auto before = copy.hash(); // whether it is a faithful copy is another law
        if (done_with(n, [&] { verb(copy); })) return true;
        if (copy.hash() != before) return false;
    }
}

} // namespace fuzz
