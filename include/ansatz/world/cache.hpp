// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Cache`: what can be made again from a world's state without changing a bit, and is therefore no part of its value.

#include <ansatz/core/compiler_flags.hpp>

namespace ansatz::detail {

/// A cache: a copy of a world begins without it, and comes to the same bits.
template <class T> struct Cache {
    T value{};
    Cache() = default;
    Cache(const Cache&) {}
    Cache(Cache&&) = default;
    Cache& operator=(const Cache&) { return *this; }
    Cache& operator=(Cache&&) = default;
};

} // namespace ansatz::detail
