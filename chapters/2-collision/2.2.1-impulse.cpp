// SPDX-License-Identifier: BSL-1.0
// 2.2.1 The impulse method: the difference of two velocities, and what restitution conserves

// J = -(1 + e) v_N / (1/m_a + 1/m_b) along N. The notes take v_ab = v_a + v_b: the relative velocity is the difference.
// With a sum two bodies that fly side by side push each other, and gain energy from nowhere. They also say that an
// elastic collision conserves all momentum and an inelastic one dissipates it: momentum is conserved by both, because
// the impulses are opposite; what is lost is kinetic energy, mu (1 - e^2) v_N^2 / 2.

#include "claims.hpp"
#include "plot.hpp"

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

#include <cmath>
#include <iostream>
#include <vector>

using namespace ansatz;

namespace {

struct After {
    double momentum, energy; // kg m/s, J
};
//! [meet]
/// 1 kg at 2 m/s meets 3 kg at -1 m/s.
After meet(double e) {
    World world{SemiImplicitEuler{}, BoundingBoxes{}, Narrowphase<Sphere>{}, Impulse<>{}};
    const auto a =
        world.add(Sphere{0.5 * metre}, velocity(metres_per_second(2, 0, 0)), mass(1.0 * kilogram), restitution(e));
    const auto b = world.add(Sphere{0.5 * metre}, position(metres(0.9, 0, 0)), velocity(metres_per_second(-1, 0, 0)),
                             mass(3.0 * kilogram));
    world.step(1e-6 * second);
    //! [meet]
    const double va = in(x(world.velocity(a)), metre_per_second), vb = in(x(world.velocity(b)), metre_per_second);
    return {va + 3 * vb, 0.5 * va * va + 1.5 * vb * vb};
}

/// The highest point of a ball with e = 1, bounce after bounce, over the height that it was dropped from.
template <class Integrator> std::vector<double> heights() {
    World world{Integrator{}, Gravity{}, BoundingBoxes{}, Narrowphase<Sphere, Plane>{}, Impulse<>{}, Projection{}};
    world.add(Plane::ground(), fixed);
    const auto ball = world.add(Sphere{0.5 * metre}, position(metres(0, 10, 0)), mass(1.0 * kilogram), restitution(1));
    std::vector<double> tops;
    double top = 0, before = 0;
    while (tops.size() < 20 && world.tick() < 10000) {
        world.step(1.0 / 60 * second);
        const double v = in(y(world.velocity(ball)), metre_per_second);
        if (before < 0 && v > 0) {
            tops.push_back(top / 9.5);
            top = 0;
        }
        top = std::max(top, in(y(world.position(ball)), metre) - 0.5);
        before = v;
    }
    return tops;
}

} // namespace

int main() {
    workbook::Claims claim;
    for (const double e : {0.0, 0.5, 1.0}) {
        const auto after = meet(e);
        std::cout << "e = " << e << ": momentum " << after.momentum << " kg m/s, energy " << after.energy << " J\n";
    }
    claim("momentum is what it was, whatever e is",
          std::abs(meet(0).momentum + 1) < 1e-12 && std::abs(meet(1).momentum + 1) < 1e-12);
    claim("e = 1 keeps the energy, 3.5 J", std::abs(meet(1).energy - 3.5) < 1e-12);
    claim("e = 0 loses mu v^2 / 2 of it, 3.375 J", std::abs(3.5 - meet(0).energy - 3.375) < 1e-12);

    //! [side by side]
    const auto v = metres_per_second(5, 0, 0);
    const auto w = 1.0 / (1.0 * kilogram);
    const auto j = collision_impulse(v, v, w, w, Eigen::Vector3d(-1, 0, 0), 1.0);
    //! [side by side]
    const double of_the_sum = -2 * (5 + 5) * -1.0 / 2; // J with v_a + v_b
    std::cout << "Side by side at 5 m/s: J = " << j << "; with the sum of the velocities it would be " << of_the_sum
              << " N s\n";
    claim("bodies that move together do not push each other", j.value() == 0);

    const auto euler = heights<ExplicitEuler>(), half = heights<SemiImplicitEuler>(),
               verlet = heights<VelocityVerlet>();
    std::cout << "After 20 bounces with e = 1: " << euler.back() << " (explicit Euler), " << half.back()
              << " (semi-implicit), " << verlet.back() << " (velocity Verlet) of the height\n";
    bool all = true;
    for (const auto& tops : {euler, half, verlet})
        for (const double top : tops) all = all && top > 0.99 && top < 1.01;
    claim("a ball with e = 1 comes back to its height, with every integrator", all);

    workbook::Plot plot("2.2.1", "Twenty bounces with e = 1");
    std::vector<double> bounces;
    for (int i = 1; i <= 20; ++i) bounces.push_back(i);
    plot.x("bounce").y("height over the first").y_range(0.9, 1.1);
    plot.linked_points("explicit Euler", bounces, euler)
        .linked_points("semi-implicit Euler", bounces, half)
        .linked_points("velocity Verlet", bounces, verlet)
        .write();
    return claim.result();
}
