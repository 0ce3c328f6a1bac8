// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// How often something allocates. One file of the program includes tests/operator_new.hpp.

#include "tests/before_allocation.hpp"

#include <cstddef>

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

} // namespace fuzz
