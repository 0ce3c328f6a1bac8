// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `State` and `Condition`: which facts hold, and which should; bits, so that two states are compared in one go.
///
/// The notes (6.2): "the way states are encoded allows a similarity comparison which can be used to calculate the
/// h-score".

#include <ansatz/core/compiler_flags.hpp>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>

namespace ansatz::goap {

/// A bit for every fact: set where it holds.
/// \tparam Words how many times 64 facts there may be
template <std::size_t Words = 1> struct State {
    std::array<std::uint64_t, Words> bits{}; ///< 64 facts a word, the first in the lowest bit

    /// Whether a fact holds, by its number.
    constexpr bool has(std::size_t fact) const { return (bits[fact / 64] >> (fact % 64) & 1) != 0; }
    /// Makes a fact hold, or not.
    constexpr void set(std::size_t fact, bool holds) {
        const std::uint64_t bit = std::uint64_t(1) << (fact % 64);
        bits[fact / 64] = holds ? bits[fact / 64] | bit : bits[fact / 64] & ~bit;
    }
    constexpr int count() const { ///< how many hold
        int n = 0;
        for (const auto word : bits) n += std::popcount(word);
        return n;
    }
    friend constexpr bool operator==(const State& a, const State& b) { // by itself it would call memcmp for 8 bytes
        std::uint64_t different = 0;
        for (std::size_t w = 0; w < Words; ++w) different |= a.bits[w] ^ b.bits[w];
        return different == 0;
    }
    /// What holds in both.
    friend constexpr State operator&(State a, const State& b) {
        for (std::size_t w = 0; w < Words; ++w) a.bits[w] &= b.bits[w];
        return a;
    }
    /// What holds in either.
    friend constexpr State operator|(State a, const State& b) {
        for (std::size_t w = 0; w < Words; ++w) a.bits[w] |= b.bits[w];
        return a;
    }
    /// What holds in one alone.
    friend constexpr State operator^(State a, const State& b) {
        for (std::size_t w = 0; w < Words; ++w) a.bits[w] ^= b.bits[w];
        return a;
    }
    /// The opposite of every bit, of those without a fact too.
    friend constexpr State operator~(State a) {
        for (auto& word : a.bits) word = ~word;
        return a;
    }
};

/// Facts that should be as in `value`, where `care` has a bit; the others do not matter.
template <std::size_t Words = 1> struct Condition {
    /// How the facts should be.
    State<Words> value, care; ///< a bit for each fact that matters
    /// Whether a state is as it should be.
    constexpr bool holds_in(const State<Words>& s) const { return unmet_in(s) == State<Words>{}; }
    /// A bit for each that is not.
    constexpr State<Words> unmet_in(const State<Words>& s) const { return (s ^ value) & care; }
    /// Whether both ask for the same.
    friend constexpr bool operator==(const Condition&, const Condition&) = default;
};

/// What a search asks: is this vertex one of those that are wanted?
template <std::size_t Words> constexpr bool is_reached(const State<Words>& s, const Condition<Words>& goal) {
    return goal.holds_in(s);
}

} // namespace ansatz::goap

template <std::size_t Words> struct std::hash<ansatz::goap::State<Words>> {
    std::size_t operator()(const ansatz::goap::State<Words>& s) const noexcept {
        std::uint64_t mixed = s.bits[0];
        for (std::size_t w = 1; w < Words; ++w) mixed = (mixed ^ (mixed >> 29)) * 0xBF58476D1CE4E5B9u + s.bits[w];
        return std::size_t(mixed);
    }
};
