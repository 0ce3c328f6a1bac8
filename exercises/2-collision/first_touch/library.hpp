// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise.
#include <ansatz/collision/narrowphase/first_touch.hpp>

#include <optional>

namespace exercise {

using Length = ansatz::Quantity<ansatz::unit::Length>;
using Place = ansatz::VectorQuantity<ansatz::unit::Length, 3>;
using Direction = ansatz::Vector<double, 3>;
struct Ball {
    Place centre, motion;
    Length radius;
};
struct Contact {
    Place point;
    Direction normal;
};

/// The library has no such formula; its contacts say how far a ball may be in a wall until the way out is the far side.
inline ansatz::Quantity<ansatz::unit::Velocity> safe_speed(Length radius, Length thickness,
                                                           ansatz::Quantity<ansatz::unit::Time> dt) {
    const ansatz::Box wall{ansatz::metres(thickness.value() / 2, 100, 100)};
    const double reach = radius.value() + thickness.value() / 2;
    double near_side = -0.999 * reach, far_side = 0.999 * reach;
    for (int i = 0; i < 60; ++i) {
        const double middle = (near_side + far_side) / 2;
        const auto touch =
            ansatz::contact(ansatz::Sphere{radius}, ansatz::metres(middle, 0, 0), wall, ansatz::metres(0, 0, 0));
        (touch->normal[0] < 0 ? near_side : far_side) = middle;
    }
    return (near_side + reach) * ansatz::metre / dt;
}

inline auto touch_of(const Ball& a, const Ball& b) {
    return ansatz::impact(ansatz::Sphere{a.radius}, a.centre, a.motion, ansatz::Sphere{b.radius}, b.centre, b.motion);
}
inline std::optional<double> first_touch(const Ball& a, const Ball& b) {
    const auto first = touch_of(a, b);
    return first ? std::optional<double>(first->time) : std::nullopt;
}
inline Contact contact_then(const Ball& a, const Ball& b, double share) {
    const auto first = touch_of(a, b);
    return {a.centre + share * a.motion + first->arm, first->normal};
}

} // namespace exercise
