// SPDX-License-Identifier: BSL-1.0
// 4.7 Wind: air acts on triangles, by how they stand in it

// Wind that pulls at each body alike, whichever way it faces, carries a flag away from its pole and holds it there,
// like a board. Air acts on areas: on what stands across it, and not on what lies along it, and it lifts what is askew.
// So where a flag bulges it is pushed on, and it never comes to rest. (A part of section 4, which the notes do not
// divide.)

#include "claims.hpp"
#include "plot.hpp"

#include <ansatz/soft_bodies/cloth.hpp>
#include <ansatz/soft_bodies/wind.hpp>
#include <ansatz/soft_bodies/xpbd.hpp>
#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <vector>

using namespace ansatz;

namespace {

constexpr std::size_t columns = 25, rows = 17;

/// Wind that pulls at each body alike: a law of one body.
struct WindOnPoints {
    using role = roles::Force;
    using reads = Columns<Velocity>;
    VectorParameter<unit::Velocity> wind;
    template <class S> struct In {
        typename S::Velocity wind;
        explicit In(const WindOnPoints& w) : wind(S::convert(w.wind)) {}
        typename S::Acceleration acceleration(const typename S::Velocity& v, const auto&) const {
            return (3.0 / second) * (wind - v);
        }
    };
};

/// A flag of 1.2 m x 0.8 m at a pole, its side at x = 0.
Cloth flag(double drag, double lift) {
    Cloth cloth{.mesh = TriangleMesh::grid(columns, rows, metres(1.2, 0, 0), metres(0, 0.8, 0)),
                .mass_per_area = 0.12 * kilogram / square_metre,
                .structural = {400.0 * newton_per_metre, 0.02 * newton_second_per_metre},
                .shear = {150.0 * newton_per_metre, 0.02 * newton_second_per_metre},
                .bend = {5.0 * newton_per_metre, 0.005 * newton_second_per_metre},
                .drag = drag,
                .lift = lift};
    for (std::size_t j = 0; j < rows; ++j) cloth.pins.push_back(std::uint32_t(columns * j));
    return cloth;
}

/// How far the middle of the free side goes across the wind in the last seconds.
template <class World_>
Quantity<unit::Length> fluttering(World_& world, const ClothParts& parts, auto& times, auto& across) {
    const Handle free = parts.bodies[columns * (rows / 2) + columns - 1];
    auto least = 1.0 * metre, most = -1.0 * metre;
    while (world.time() < 8.0 * second) {
        world.step(1.0 / 60 * second);
        const auto here = z(world.position(free));
        if (world.time() > 4.0 * second) {
            least = std::min(least, here);
            most = std::max(most, here);
            times.push_back(world.time());
            across.push_back(here);
        }
    }
    return most - least;
}

} // namespace

int main() {
    workbook::Claims claim;

    // A plate of a square metre in a wind of 10 m/s: two triangles.
    std::cout << "   a plate turned out of the wind by   is pushed along it   and across it\n" << std::fixed;
    std::vector<double> angles, along, across;
    bool as_it_should = true;
    const double head = 0.5 * 1.2 * 10 * 10; // N/m^2, times the coefficients
    for (int degree = 0; degree <= 90; degree += 15) {
        const double turn = degrees(degree).value();
        //! [plate]
        World air{SemiImplicitEuler{}, Springs{}, Wind{.velocity = metres_per_second(10, 0, 0)}};
        const auto plate = add_cloth(
            air, {.mesh = TriangleMesh::grid(2, 2, metres(std::sin(turn), std::cos(turn), 0), metres(0, 0, 1)),
                  .mass_per_area = 1.0 * kilogram / square_metre,
                  .drag = 1.2,
                  .lift = 0.8});
        //! [plate]
        air.step(1e-6 * second);
        VectorQuantity<unit::Force> force{};
        for (const Handle body : plate.bodies) force += air.mass(body) * air.velocity(body) / (1e-6 * second);
        const double c = std::cos(turn), lift = 0.8 * head * c * std::sin(turn);
        as_it_should = as_it_should && std::abs(x(force) / newton - 1.2 * head * c) < 1e-3 &&
                       std::abs(std::abs(y(force) / newton) - lift) < 1e-3;
        std::cout << std::setw(28) << degree << " deg" << std::setprecision(2) << std::setw(20) << x(force) / newton
                  << " N" << std::setw(15) << std::abs(y(force) / newton) << " N\n";
        angles.push_back(degree);
        along.push_back(x(force) / newton);
        across.push_back(std::abs(y(force) / newton));
    }
    claim("drag is that of the area that faces the wind, lift is largest at 45 degrees", as_it_should);

    // A flag, by triangles and by points.
    //! [flag]
    World triangles{SemiImplicitEuler{}, Gravity{}, Springs{}, Xpbd{.substeps = 15},
                    Wind{metres_per_second(6, 0, 0.3)}};
    const auto on_triangles = add_cloth(triangles, flag(0.4, 1.0));
    //! [flag]
    World points{SemiImplicitEuler{}, Gravity{}, Springs{}, Xpbd{.substeps = 15},
                 WindOnPoints{metres_per_second(6, 0, 0.3)}};
    const auto on_points = add_cloth(points, flag(0, 0));
    std::vector<Quantity<unit::Time>> times, same;
    std::vector<Quantity<unit::Length>> by_triangles, by_points;
    const auto flutters = fluttering(triangles, on_triangles, times, by_triangles);
    const auto stands = fluttering(points, on_points, same, by_points);
    std::cout << "   the free side goes to and fro by " << std::setprecision(1) << flutters / metre
              << " m where wind blows on triangles,\n   and by " << stands / metre << " m where it pulls at points\n";
    claim("a flag whose triangles feel the wind flutters", flutters > 0.1 * metre);
    claim("one whose points are pulled stands like a board", stands < 0.01 * metre);

    // Still air takes what a flag has, and gives nothing.
    //! [calm]
    triangles.set(Wind{});
    //! [calm]
    for (int i = 0; i < 720; ++i) triangles.step(1.0 / 60 * second);
    const Handle corner = on_triangles.bodies[columns * (rows / 2) + columns - 1];
    std::cout << "   when the wind has died down it hangs " << -(y(triangles.position(corner)) / metre - 0.4)
              << " m lower\n";
    claim("without wind it hangs down at its pole", y(triangles.position(corner)) < -0.1 * metre);

    workbook::Plot forces("4.7", "A plate of 1 m^2 in a wind of 10 m/s");
    forces.x("turned out of the wind", "degrees").y("force", "N");
    forces.line("along the wind", angles, along).line("across it", angles, across).write();
    workbook::Plot plot("4.7-flag", "The free side of a flag: how far it is across the wind");
    plot.x("time").y("across the wind").line("wind on triangles", times, by_triangles);
    plot.line("wind on points", same, by_points).write();
    return claim.result();
}
