// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `StateHash`: a 64-bit hash of numbers by value, the same in every build and on every machine with IEEE 754 numbers.
/// For comparing states of worlds; not for security, and not for hash tables of untrusted keys.

#include <ansatz/core/compiler_flags.hpp>

#include <bit>
#include <concepts>
#include <cstdint>

namespace ansatz {

/// The hash of the words taken in so far; 64 bits, the same on every machine.
class StateHash {
public:
    /// Takes a word in.
    void add(std::uint64_t word) {
        // FNV's shape on whole words, with a shift that brings high bits down (splitmix64's constants).
        hash_ = (hash_ ^ word) * 0xbf58476d1ce4e5b9u;
        hash_ ^= hash_ >> 29;
    }
    /// A number by value: both zeros are one value, and so are all NaNs. A class scalar is taken apart into doubles.
    template <class T> void add_number(const T& number) {
        if constexpr (std::same_as<T, float> || std::same_as<T, double>) {
            const double wide = double(number); // exact
            add(wide == 0 ? 0 : wide != wide ? 0x7ff8000000000000u : std::bit_cast<std::uint64_t>(wide));
        } else {
            T rest = number;
            for (int piece = 0; piece < 8; ++piece) {
                const double part = static_cast<double>(rest);
                add_number(part);
                if (part == 0 || part != part || part - part != 0) return;
                rest -= part;
            }
        }
    }
    /// The hash of what was taken in.
    std::uint64_t value() const { return hash_; }

private:
    std::uint64_t hash_ = 0xcbf29ce484222325u;
};

} // namespace ansatz
