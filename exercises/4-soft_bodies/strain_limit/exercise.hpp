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
    return todo(1);
}

/// 4.8: takes the velocity with which two ends go away from each other.
inline void stop(End& first, End& second) {
    todo(2);
}

/// 4.8: passes over all springs of a sheet, to and fro, until none is stretched by more than `most` of its rest length.
/// \return how many passes it made, the one that found nothing included: `passes` at most
inline int limit(Sheet& sheet, double most, int passes) {
    return todo(3);
}

} // namespace exercise
