// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Cache`: what can be made again from a world's state without changing a bit, and is therefore no part of its value.

#include <ansatz/core/compiler_flags.hpp>

#include <cstddef>
#include <cstdint>
#include <utility>

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

/// A number that changes with what it stands beside, for a cache elsewhere in the same world that was made from it. It
/// changes when another world is assigned, too, since the cache does not come along.
struct Stamp {
    std::uint64_t value = 0;
    Stamp() = default;
    Stamp(const Stamp&) {}
    Stamp(Stamp&&) = default;
    Stamp& operator=(const Stamp&) {
        ++value;
        return *this;
    }
    Stamp& operator=(Stamp&&) = default;
};

/// For how many bodies every table has room. A copied vector has no more than it needs, and one that is assigned keeps
/// what it has.
struct Room {
    std::size_t bodies = 0;
    Room() = default;
    Room(const Room&) {}
    Room(Room&& other) noexcept : bodies(std::exchange(other.bodies, 0)) {}
    Room& operator=(const Room&) { return *this; }
    Room& operator=(Room&& other) noexcept {
        bodies = std::exchange(other.bodies, 0);
        return *this;
    }
    Room& operator=(std::size_t n) {
        bodies = n;
        return *this;
    }
    // NOLINTNEXTLINE(google-explicit-constructor)
    operator std::size_t() const { return bodies; }
};

} // namespace ansatz::detail
