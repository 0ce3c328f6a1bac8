// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What a program that the fuzzer printed needs, where it is pasted.

#include "tests/catch.hpp"
#include "tests/fuzz/allocations.hpp"
#include "tests/world/files.hpp"

#include <ansatz/collision.hpp>
#include <ansatz/motion.hpp>
#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>
#include <ansatz/world/keep.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace fuzz {

/// How far a place or a velocity is from what it should be, m or m/s.
inline double apart(const auto& is, const std::array<double, 3>& should) {
    double sum = 0;
    for (int k = 0; k < is.value().size(); ++k) {
        const double d = double(is.value()[k]) - should[std::size_t(k)];
        sum += d * d;
    }
    return std::sqrt(sum);
}
/// Whether two bodies are in contact.
inline bool touch(const auto& world, ansatz::Handle a, ansatz::Handle b) {
    return std::any_of(world.contacts().begin(), world.contacts().end(), [&](const auto& c) {
        return (c.first == a && c.second == b) || (c.first == b && c.second == a);
    });
}

} // namespace fuzz

using namespace ansatz;       // NOLINT(google-build-using-namespace): as a test does
using namespace ansatz::test; // NOLINT(google-build-using-namespace)
