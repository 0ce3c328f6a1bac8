// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "todo.hpp"

#include <ansatz/world.hpp>

#include <vector>

using namespace ansatz;

namespace exercise {

/// Where a motion ends: how far from its start, and how fast.
struct End {
    Quantity<unit::Length> s;
    Quantity<unit::Velocity> v;
};

/// 1.5: the end of a motion that starts with u and has the constant acceleration a for the time t.
inline End after(Quantity<unit::Velocity> u, Quantity<unit::Acceleration> a, Quantity<unit::Time> t) {
    return todo(1);
}

/// The displacement of a motion that ends with v, after it had the constant acceleration a for the time t.
inline Quantity<unit::Length> displacement_until(Quantity<unit::Velocity> v, Quantity<unit::Acceleration> a,
                                                 Quantity<unit::Time> t) {
    return todo(2);
}

/// All times at which a motion is displaced by s that starts with u and has the constant acceleration a, the earlier
/// first. u and a are not both zero.
inline std::vector<Quantity<unit::Time>> times_at(Quantity<unit::Length> s, Quantity<unit::Velocity> u,
                                                  Quantity<unit::Acceleration> a) {
    return todo(3);
}

} // namespace exercise
