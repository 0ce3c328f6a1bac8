// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <ansatz/world.hpp>

#include <cstddef>
#include <utility>
#include <vector>

using namespace ansatz;

namespace exercise {

/// One end of a spring.
struct End {
    VectorQuantity<unit::Length, 3> position;
    VectorQuantity<unit::Velocity, 3> velocity;
    Quantity<unit::InverseMass> inverse_mass; ///< zero where it is held
};
/// A spring of a sheet.
struct Thread {
    std::size_t first, second; ///< its ends, by number
    Quantity<unit::Length> rest_length;
};
struct Sheet {
    std::vector<End> ends;
    std::vector<Thread> threads;
};

/// What is too long by no more than this part of its length is not too long.
constexpr double rounding = 1e-12;

/// 4.8: brings two ends together until they are no further apart than `longest`.
/// \return whether they were, and at least one of them could be moved
inline bool shorten(End& first, End& second, Quantity<unit::Length> longest) {
    // task 1: return todo(1);
    const VectorQuantity<unit::Length, 3> to = second.position - first.position;
    const auto length = norm(to);
    const auto weights = first.inverse_mass + second.inverse_mass;
    if (length <= (1 + rounding) * longest || weights == 0.0 / kilogram) return false;
    const VectorQuantity<unit::Length, 3> way = (length - longest) / length * to;
    first.position += first.inverse_mass / weights * way;
    second.position -= second.inverse_mass / weights * way;
    return true;
    // end of task 1
}

/// 4.8: takes the velocity with which two ends go away from each other.
inline void stop(End& first, End& second) {
    // task 2: todo(2);
    const VectorQuantity<unit::Length, 3> to = second.position - first.position;
    const VectorQuantity<unit::Dimensionless, 3> axis = to / norm(to);
    const auto apart = dot(second.velocity - first.velocity, axis);
    const auto weights = first.inverse_mass + second.inverse_mass;
    if (apart <= 0.0 * metre_per_second || weights == 0.0 / kilogram) return;
    first.velocity += first.inverse_mass / weights * apart * axis;
    second.velocity -= second.inverse_mass / weights * apart * axis;
    // end of task 2
}

/// 4.8: passes over all springs of a sheet, to and fro, until none is stretched by more than `most` of its rest length.
/// \return how many passes it made, the one that found nothing included: `passes` at most
inline int limit(Sheet& sheet, double most, int passes) {
    // task 3: return todo(3);
    auto& [ends, threads] = sheet;
    for (int pass = 1; pass <= passes; ++pass) {
        bool found = false;
        for (std::size_t i = 0; i < threads.size(); ++i) {
            const auto& [first, second, rest_length] = threads[pass % 2 == 1 ? i : threads.size() - 1 - i];
            const auto longest = (1 + most) * rest_length;
            if (!shorten(ends[first], ends[second], longest)) continue;
            stop(ends[first], ends[second]);
            found = true;
        }
        if (!found) return pass;
    }
    return passes;
    // end of task 3
}

} // namespace exercise
