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
#include <cmath>

namespace fuzz {

/// Whether two bodies are in contact.
inline bool touch(const auto& world, ansatz::Handle a, ansatz::Handle b) {
    return std::any_of(world.contacts().begin(), world.contacts().end(), [&](const auto& c) {
        return (c.first == a && c.second == b) || (c.first == b && c.second == a);
    });
}

} // namespace fuzz

using namespace ansatz;       // NOLINT(google-build-using-namespace): as a test does
using namespace ansatz::test; // NOLINT(google-build-using-namespace)
