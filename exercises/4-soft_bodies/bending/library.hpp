// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise: the constraint that its Bending computes with.
#include <ansatz/soft_bodies/bending.hpp>
#include <ansatz/world.hpp>

#include <array>
#include <cstddef>

namespace exercise {

using Corners = std::array<ansatz::VectorQuantity<ansatz::unit::Length, 3>, 4>;
using Angle = ansatz::Quantity<ansatz::unit::PlaneAngle>;
using Gradient = ansatz::VectorQuantity<ansatz::unit::InverseLength, 3>;

/// How far the angle is from the one at rest, rad, and its gradient, 1/m.
struct Linear {
    double off;
    std::array<ansatz::Vector<double, 3>, 4> gradient;
    Linear(const Corners& at, double rest) {
        std::array<ansatz::Vector<double, 3>, 4> x;
        for (std::size_t i = 0; i < 4; ++i) x[i] = at[i].value();
        off = ansatz::HingeConstraint<ansatz::Space<>>{{}, rest, 1.0, 0.0}.linearise(x, gradient);
    }
};

inline Angle angle(const Corners& at) { return ansatz::radians(Linear(at, 0).off); }

inline std::array<Gradient, 4> gradient(const Corners& at) {
    const Linear linear(at, 0);
    std::array<Gradient, 4> all;
    for (std::size_t i = 0; i < 4; ++i) all[i] = Gradient::from_value(linear.gradient[i]);
    return all;
}

inline std::array<ansatz::VectorQuantity<ansatz::unit::Force, 3>, 4>
forces(const Corners& at, ansatz::Quantity<ansatz::unit::Energy> stiffness, Angle rest) {
    using Force = ansatz::VectorQuantity<ansatz::unit::Force, 3>;
    const Linear linear(at, rest.value());
    std::array<Force, 4> all;
    for (std::size_t i = 0; i < 4; ++i)
        all[i] = Force::from_value(-stiffness.value() * linear.off * linear.gradient[i]);
    return all;
}

} // namespace exercise
