// SPDX-License-Identifier: BSL-1.0
// 4.2 Moved at a corner: the nearest springs act first, and the movement runs to all of the surface

// "When it is moved the springs closest to the point at which the cloth is being moved will begin to act upon their
// neighbouring meshes which propagates back to almost all of the surface." How fast? A line of bodies of mass m, a
// distance L apart, passes a movement on with c = L sqrt(k/m) (section 3.3). In a sheet the diagonals help: with shear
// springs of half the stiffness it is alike in all directions, and c = L sqrt((k + k/2)/m). (A part of section 4, which
// the notes do not divide.)

#include "claims.hpp"
#include "plot.hpp"

#include <ansatz/soft_bodies.hpp>
#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <vector>

using namespace ansatz;

int main() {
    workbook::Claims claim;
    const std::size_t n = 40;
    const auto L = 0.025 * metre;
    const auto k = 40.0 * newton_per_metre;
    const auto density = 0.16 * kilogram / square_metre;
    const auto side = double(n - 1) * L;

    //! [corner]
    World world{SemiImplicitEuler{}, Springs{}};
    const ClothParts sheet = add_cloth(
        world, {.mesh = TriangleMesh::grid(n, n, side * Vector<double, 3>(1, 0, 0), side * Vector<double, 3>(0, 1, 0)),
                .mass_per_area = density,
                .structural = {k},
                .shear = {0.5 * k},          // the same in all directions
                .dragged = {0},              // the corner goes where it is sent
                .lumping = Lumping::equal}); // by area the light border would run ahead
    const auto quiet = world;
    world.set_velocity(sheet.bodies[0], metres_per_second(-0.05, -0.05, 0));
    //! [corner]
    const auto dt = 0.2 * stable_step(world);

    // The corner sets out in one step; each step after it reaches one ring of neighbours.
    //! [rings]
    world.step(dt);
    bool in_rings = true;
    for (std::size_t step = 1; step <= 5; ++step) {
        world.step(dt);
        for (std::size_t v = 0; v < n * n; ++v) {
            const std::size_t ring = std::max(v % n, v / n);
            const bool moves = norm(world.velocity(sheet.bodies[v])).value() != 0;
            if (moves && ring > step) in_rings = false;                     // no body moves before its turn
            if (ring == step && v % n == v / n && !moves) in_rings = false; // nor later, along the diagonal
        }
    }
    //! [rings]
    claim("the springs at the corner act first, and each step reaches the neighbours of those that it has reached",
          in_rings);

    // When a body has moved by a thousandth of a millimetre it counts as reached.
    std::vector<Quantity<unit::Time>> arrival(n * n), times;
    std::vector<double> share;
    std::size_t reached = 0;
    const auto end = 0.25 * second;
    std::vector<bool> known(n * n);
    while (world.time() < end) {
        world.step(dt);
        for (std::size_t v = 0; v < n * n; ++v)
            if (!known[v] && norm(world.position(sheet.bodies[v]) - quiet.position(sheet.bodies[v])) > 1e-6 * metre) {
                known[v] = true;
                arrival[v] = world.time();
                ++reached;
            }
        times.push_back(world.time());
        share.push_back(double(reached) / double(n * n));
    }
    std::vector<double> distances;
    std::vector<Quantity<unit::Time>> arrivals;
    for (std::size_t v = 0; v < n * n; ++v)
        if (known[v]) {
            distances.push_back(norm(quiet.position(sheet.bodies[v]) - quiet.position(sheet.bodies[0])).value());
            arrivals.push_back(arrival[v]);
        }
    std::cout << "After " << times.back() << " the movement has reached " << reached << " of " << n * n << " bodies\n";
    claim("it runs to almost all of the surface", share.back() > 0.99);

    const auto m = density * side * side / double(n * n);
    const auto c = L * sqrt(1.5 * k / m);
    // By the slope along the diagonal, because what "reached" means shifts all of them alike.
    const auto at = [&](std::size_t i) { return i + n * i; };
    const auto apart = double(25) * L * std::sqrt(2.0);
    const Quantity<unit::Velocity> measured = apart / (arrival[at(32)] - arrival[at(7)]);
    std::cout << "It runs at " << measured << " along the diagonal; L sqrt((k + k/2)/m) is " << c << '\n';
    claim("as fast as the springs and masses say", abs(measured - c) < 0.1 * c);
    bool in_order = true;
    for (std::size_t v = 0; v < n * n; ++v)
        for (std::size_t w = 0; w < n * n; ++w) // a body farther away by two cells is reached later
            if (distances[v] + 2 * L.value() < distances[w] && !(arrivals[v] < arrivals[w])) in_order = false;
    claim("who is nearer is reached first, in every direction", in_order);

    workbook::Plot plot("4.2", "When the movement of a corner reaches each body of the sheet");
    std::vector<double> line;
    for (int i = 0; i <= 20; ++i) line.push_back(side.value() * std::sqrt(2.0) * i / 20);
    plot.x("distance from the corner", "m").y("time when it arrives");
    plot.points("measured", distances, arrivals)
        .reference("at L sqrt((k + k/2)/m)", line, [&](double d) { return d / c.value() * second; })
        .write();
    return claim.result();
}
