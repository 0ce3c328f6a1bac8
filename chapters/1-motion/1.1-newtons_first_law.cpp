// SPDX-License-Identifier: BSL-1.0
// 1.1 Newton's first law: left alone, a body keeps its velocity; what must not move is never computed

// In an inertial frame a body moves straight on unless a force acts. In a world this is what happens when its list of
// policies names no force. The notes add two things for games: what stands for ever (the ground) is immune to physics,
// and what stands for now rests until something makes it move. Here the first is `fixed` and the second the policy
// Rest.

#include "claims.hpp"
#include "plot.hpp"

#include <ansatz/world.hpp>

#include <iostream>
#include <vector>

using namespace ansatz;

int main() {
    workbook::Claims claim;
    const auto dt = 1.0 / 60 * second;

    // No force in the list: every integrator is exact, but for the rounding of its sums.
    //! [free]
    World space{SemiImplicitEuler{}};
    const auto probe = space.add(velocity(metres_per_second(3, 4, 0)));
    while (space.tick() < 3600) space.step(dt);
    //! [free]
    std::cout << "A probe in empty space after " << space.time() << ": velocity " << space.velocity(probe)
              << ", distance " << norm(space.position(probe)) << '\n';
    claim("its velocity is what it was, to the last bit", space.velocity(probe) == metres_per_second(3, 4, 0));
    claim("it is 300 m from where it started", abs(norm(space.position(probe)) - 300.0 * metre) < 1e-9 * metre);

    // The law holds for forces that balance: the resultant counts, not whether something pushes.
    //! [balance]
    const auto weight = newtons(0, -19.62, 0), table = newtons(0, 19.62, 0);
    claim("a book on a table: two forces, no resultant, no change", mechanics::in_equilibrium(weight, table));
    //! [balance]

    // The same throw above the ground: gravity bends the path, and the ground does not fall.
    //! [garden]
    World garden{SemiImplicitEuler{}, Gravity{}, Rest{}, AppliedForces{}};
    const auto ground = garden.add(fixed);
    const auto ball = garden.add(position(metres(0, 1, 0)), velocity(metres_per_second(3, 4, 0)), mass(0.4 * kilogram));
    //! [garden]
    std::vector<Quantity<unit::Length>> far, high, far_alone, high_alone;
    for (int i = 0; i < 48; ++i) {
        far.push_back(x(garden.position(ball)));
        high.push_back(y(garden.position(ball)));
        far_alone.push_back(x(metres(0, 1, 0) + garden.time() * metres_per_second(3, 4, 0)));
        high_alone.push_back(y(metres(0, 1, 0) + garden.time() * metres_per_second(3, 4, 0)));
        garden.step(dt);
    }
    std::cout << "A ball thrown in the garden after " << garden.time() << ": velocity " << garden.velocity(ball)
              << '\n';
    claim("a force, and the velocity changes", garden.velocity(ball) != metres_per_second(3, 4, 0));
    claim("only along the force", x(garden.velocity(ball)) == 3.0 * metre_per_second);
    claim("the ground is where it was",
          garden.position(ground) == metres(0, 0, 0) && garden.motion(ground) == Motion::fixed);

    // Nothing reaches a fixed body, no push from outside either: it has infinite mass.
    //! [immune]
    garden.apply_force(ground, newtons(0, 1e6, 0));
    garden.step(dt);
    claim("a million newtons under the ground do nothing", garden.position(ground) == metres(0, 0, 0));
    //! [immune]

    workbook::Plot plot("1.1", "Left alone, a body moves straight on");
    plot.x("distance").y("height").reference("no force", far_alone, high_alone).line("gravity", far, high).write();
    return claim.result();
}
