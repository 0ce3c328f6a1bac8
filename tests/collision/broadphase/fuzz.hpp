// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The fuzz target of the broadphases: bytes become boxes, of any floats whatever. Boxes that are refused are told to
/// be wrong and nothing more happens; of the others every policy must tell the same pairs. `find` itself, which does
/// not check, may miss pairs of boxes that are none, but must neither crash nor tell what is not there.
///
/// In the tests a driver feeds it bytes of its own; with clang++ -fsanitize=fuzzer,address,undefined -DANSATZ_LIBFUZZER
/// hostile.cpp becomes a libFuzzer program.

#include "tests/collision/broadphase/scenes.hpp"

#include <cstdlib>
#include <cstring>
#include <stdexcept>

namespace broadphase_tests {

/// What was wrong, or nothing.
template <class S> std::string fuzz_in(const std::uint8_t* data, std::size_t size) {
    using Scalar = typename S::Scalar;
    constexpr std::size_t each = 2 * std::size_t(S::dimension) * sizeof(Scalar);
    Boxes<S> boxes;
    if (size < 1) return {};
    const std::size_t n = std::min<std::size_t>((size - 1) / each, 64);
    for (std::size_t i = 0; i < n; ++i) {
        std::array<Scalar, 6> numbers{};
        std::memcpy(numbers.data(), data + 1 + i * each, each);
        Vector<Scalar, S::dimension> low, high;
        for (int k = 0; k < S::dimension; ++k)
            low[k] = numbers[2 * std::size_t(k)], high[k] = numbers[2 * std::size_t(k) + 1];
        boxes.push_back(S::Position::from_value(low), S::Position::from_value(high));
    }
    boxes.set_active(n == 0 ? 0 : data[0] % (n + 1));
    bool refused = false;
    try {
        boxes.check("fuzz");
    } catch (const std::invalid_argument&) {
        refused = true;
    }
    if (!refused) return fault_of_any(boxes);
    std::string fault;
    each_policy([&](const char* name, const auto& policy) {
        typename std::remove_cvref_t<decltype(policy)>::template In<S> bound(policy);
        bound.find(boxes, [&](std::size_t i, std::size_t j) {
            if (i >= j || j >= n || i >= boxes.active()) fault = std::string(name) + ": a pair that cannot be";
        });
        try {
            find_pairs(policy, boxes);
            fault = std::string(name) + ": boxes that are none were not refused";
        } catch (const std::invalid_argument&) {
        }
    });
    return fault;
}
inline std::string fuzz(const std::uint8_t* data, std::size_t size) {
    for (const auto& fault : {fuzz_in<Space<double, 3>>(data, size), fuzz_in<Space<float, 2>>(data, size)})
        if (!fault.empty()) return fault;
    return {};
}

} // namespace broadphase_tests
