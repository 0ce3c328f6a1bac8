// SPDX-License-Identifier: BSL-1.0
// What accuracy costs in chapter 2: broadphases, contacts, responses, the solver, rest

// Five axes, each in a file of its own beside this one:
//
// - broadphase: how many pairs each tests for one that touches, and how long a body takes, against the number of
//   bodies and how they are spread. No broadphase misses a pair; what differs is the waste.
// - narrowphase: how wrong depth and normal of a contact are, in float and double, near the origin and far from it.
// - response: every integrator with every response, on a ball that should come back to its height for ever.
// - solver: what is left after so many sweeps, and how heavy a body may be that lies on a light one.
// - rest: how far a world in which bodies fall asleep is from one in which none does, and what that saves.

#include "what_it_costs.hpp"

int main(int argc, char** argv) {
    collision_costs::Costs costs("collision", argc, argv);
    collision_costs::add_broadphase(costs);
    collision_costs::add_narrowphase(costs);
    collision_costs::add_response(costs);
    collision_costs::add_solver(costs);
    collision_costs::add_rest(costs);
    return costs.run();
}
