// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise: what its Pressure computes with.
#include <ansatz/soft_bodies/enclosure.hpp>
#include <ansatz/world.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace exercise {

using Points = std::vector<ansatz::VectorQuantity<ansatz::unit::Length, 3>>;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

inline ansatz::EnclosureRow<ansatz::Space<>> enclosure(const Triangles& triangles) {
    ansatz::EnclosureRow<ansatz::Space<>> row;
    for (const auto& t : triangles) row.corners.insert(row.corners.end(), t.begin(), t.end());
    return row;
}

inline ansatz::Quantity<ansatz::unit::Volume> volume(const Points& points, const Triangles& triangles) {
    return enclosure(triangles).volume_at([&](std::size_t i) { return points[i].value(); }) * ansatz::cubic_metre;
}

struct Gas {
    ansatz::Quantity<ansatz::unit::Pressure> inside;
    ansatz::Quantity<ansatz::unit::Volume> filled;
    ansatz::Quantity<ansatz::unit::Pressure> outside;
};

inline ansatz::Quantity<ansatz::unit::Pressure> pressure(const Gas& gas, ansatz::Quantity<ansatz::unit::Volume> v) {
    const ansatz::detail::FillingLaw<double> law{gas.inside.value(), gas.outside.value(), 0.0, gas.filled.value()};
    return law.excess(v.value()) * ansatz::pascal;
}

inline std::vector<ansatz::VectorQuantity<ansatz::unit::Force, 3>>
forces(const Points& points, const Triangles& triangles, ansatz::Quantity<ansatz::unit::Pressure> pressure) {
    std::vector<ansatz::Vector<double, 3>> gradients(points.size());
    enclosure(triangles).gradients([&](std::size_t i) { return points[i].value(); }, 0,
                                   std::span<ansatz::Vector<double, 3>>(gradients));
    std::vector<ansatz::VectorQuantity<ansatz::unit::Force, 3>> all;
    for (const auto& g : gradients)
        all.push_back(ansatz::VectorQuantity<ansatz::unit::Force, 3>::from_value(pressure.value() * g));
    return all;
}

} // namespace exercise
