// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise: what its SurfaceContacts do to bodies of a kilogram in a second. The
// radius of a body is that of its footprint from one and a half columns on.
#include <ansatz/water/surface_contacts.hpp>
#include <ansatz/world.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace exercise {

struct Surface {
    ansatz::Quantity<ansatz::unit::Length> width;
    std::vector<ansatz::Quantity<ansatz::unit::Length>> heights;
    std::vector<ansatz::Quantity<ansatz::unit::Velocity>> rises;
};
struct Body {
    ansatz::VectorQuantity<ansatz::unit::Length, 2> position;
    ansatz::VectorQuantity<ansatz::unit::Velocity, 2> velocity;
    ansatz::Quantity<ansatz::unit::Length> radius;
};
struct Contact {
    ansatz::Quantity<ansatz::unit::Stiffness> stiffness;
    ansatz::Quantity<ansatz::unit::Damping> damping;
};
struct Forces {
    ansatz::VectorQuantity<ansatz::unit::Force, 2> on_body;
    std::vector<ansatz::Quantity<ansatz::unit::Force>> on_columns;
};

inline Forces carry(const Surface& surface, const Body& body, const Contact& contact) {
    using namespace ansatz;
    World world{Space<double, 2>{}, SemiImplicitEuler{}, SurfaceContacts{}};
    const auto one = mass(1.0 * kilogram);
    std::vector<Handle> columns;
    for (std::size_t i = 0; i < surface.heights.size(); ++i)
        columns.push_back(world.add(position(metres(double(i) * surface.width.value(), surface.heights[i].value())),
                                    velocity(metres_per_second(0, surface.rises[i].value())), one));
    const auto carried = world.add(position(body.position), velocity(body.velocity), one);
    const auto first = -0.5 * surface.width;
    world.add(SurfaceContact{.body = carried,
                             .grid = ColumnGrid(columns.size(), 1, surface.width, surface.width).at(first, first),
                             .columns = columns,
                             .spring = {contact.stiffness, contact.damping, 1e9 * metre},
                             .radius = body.radius});
    world.step(1.0 * second);
    const auto per_second = kilogram / second;
    Forces forces{(world.velocity(carried) - body.velocity) * per_second, {}};
    for (std::size_t i = 0; i < columns.size(); ++i)
        forces.on_columns.push_back((y(world.velocity(columns[i])) - surface.rises[i]) * per_second);
    return forces;
}

/// On a body that lies deep in the surface.
inline Forces deep(const Surface& surface, ansatz::Quantity<ansatz::unit::Length> at,
                   ansatz::Quantity<ansatz::unit::Length> reach) {
    using namespace ansatz;
    auto still = surface;
    for (auto& rise : still.rises) rise = 0.0 * metre_per_second;
    return carry(still, {metres(at.value(), -100), metres_per_second(0, 0), reach},
                 {1.0 * newton_per_metre, 0.0 * newton_second_per_metre});
}

inline std::vector<double> weights(const Surface& surface, ansatz::Quantity<ansatz::unit::Length> at,
                                   ansatz::Quantity<ansatz::unit::Length> reach) {
    const auto forces = deep(surface, at, reach);
    std::vector<double> all;
    double sum = 0;
    for (const auto& force : forces.on_columns) sum -= force.value();
    for (const auto& force : forces.on_columns) all.push_back(sum > 0 ? -force.value() / sum : 0);
    return all;
}

inline double slope(const Surface& surface, ansatz::Quantity<ansatz::unit::Length> at,
                    ansatz::Quantity<ansatz::unit::Length> reach) {
    const auto force = deep(surface, at, reach).on_body.value();
    return force[1] > 0 ? -force[0] / force[1] : 0;
}

} // namespace exercise
