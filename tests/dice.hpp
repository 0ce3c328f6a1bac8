// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Numbers that are the same on every machine and with every standard library.

#include <concepts>
#include <cstdint>

namespace ansatz::test {

class Dice {
public:
    explicit Dice(std::uint64_t seed) : state_(seed) {}
    std::uint64_t next() { // splitmix64
        std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    template <std::integral T> T below(T n) { return T(next() % std::uint64_t(n)); }
    bool one_in(int n) { return below(n) == 0; }
    double number(double from, double to) { return from + (to - from) * (double(next() >> 11) * 0x1p-53); }

private:
    std::uint64_t state_;
};

} // namespace ansatz::test
