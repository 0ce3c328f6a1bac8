// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise: what its Wind does to bodies of a kilogram in a second.
#include <ansatz/soft_bodies/wind.hpp>
#include <ansatz/world.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace exercise {

using Position = ansatz::VectorQuantity<ansatz::unit::Length, 3>;
using Speed = ansatz::VectorQuantity<ansatz::unit::Velocity, 3>;
using Facing = ansatz::VectorQuantity<ansatz::unit::Area, 3>;
using Push = ansatz::VectorQuantity<ansatz::unit::Force, 3>;

struct Air {
    ansatz::Quantity<ansatz::unit::Density> density;
    double drag, lift;
};
struct Cloth {
    std::vector<Position> points;
    std::vector<Speed> velocities;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

inline Facing area(const Position& a, const Position& b, const Position& c) {
    return 0.5 * ansatz::cross(b - a, c - a);
}

inline std::vector<Push> blow(const Cloth& cloth, const Speed& wind, const Air& air) {
    using namespace ansatz;
    World world{SemiImplicitEuler{}, Wind{.velocity = wind, .density = air.density}};
    std::vector<Handle> bodies;
    for (std::size_t i = 0; i < cloth.points.size(); ++i)
        bodies.push_back(world.add(position(cloth.points[i]), velocity(cloth.velocities[i]), mass(1.0 * kilogram)));
    for (const auto& [a, b, c] : cloth.triangles)
        world.add(Sail{{bodies[a], bodies[b], bodies[c]}, air.drag, air.lift});
    world.step(1.0 * second);
    std::vector<Push> forces;
    for (std::size_t i = 0; i < bodies.size(); ++i)
        forces.push_back((world.velocity(bodies[i]) - cloth.velocities[i]) / (1.0 * second) * (1.0 * kilogram));
    return forces;
}

/// On a triangle that has this area, at rest.
inline Push force(const Facing& area, const Speed& w, const Air& air) {
    using namespace ansatz;
    const Eigen::Vector3d normal = area.value().normalized(), one = normal.unitOrthogonal(), other = normal.cross(one);
    const double twice = 2 * area.value().norm();
    const Position origin = metres(0, 0, 0);
    const Speed still = metres_per_second(0, 0, 0);
    const auto forces = blow(
        {{origin, Position::from_value(one), Position::from_value(twice * other)}, {still, still, still}, {{0, 1, 2}}},
        w, air);
    return forces[0] + forces[1] + forces[2];
}

} // namespace exercise
