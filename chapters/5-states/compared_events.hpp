// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What the machines that `what_it_costs` of chapter 5 compares do: their events, and what each transition counts.

#include <cstdint>

namespace compared {

constexpr int events = 5;
/// Whether state s answers event e, and with which state.
constexpr bool answers(int s, int e) { return (s + e) % 10 != 9; }
constexpr int next(int s, int e, int n) { return (s * 7 + e * 3 + 1) % n; }

/// What the machines decide about: something that depends on every transition that was taken, and on their order.
struct Tally {
    std::uint32_t sum = 0;
};
/// What is done with the transition of state s on event e, where anything is done.
template <int S, int E> inline void act(Tally& t) {
    if constexpr ((S + E) % 3 == 0) t.sum += S + 1;
    else if constexpr ((S + E) % 3 == 1) t.sum ^= 8 * E + 5;
    else t.sum = 3 * t.sum + S;
}

} // namespace compared
