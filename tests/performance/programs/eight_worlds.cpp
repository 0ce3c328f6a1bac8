// SPDX-License-Identifier: BSL-1.0
// Two piles that fall and come to lie, or one of them (ANSATZ_ONLY_IMPULSE, ANSATZ_ONLY_SUBSTEPS). With ANSATZ_EIGHT
// seven further worlds stand in the same file and are not run: g++ inlines less in a file that grows
// (tests/performance/eight_worlds.sh).

#include <ansatz/collision.hpp>
#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

template <class... P> [[gnu::noinline]] double pile(int steps, P... policies) {
    World world{policies...};
    world.add(Plane::ground(), fixed);
    for (int i = 0; i < 200; ++i)
        world.add(Sphere{0.5 * metre}, position(metres(1.01 * (i % 5), 0.5 + 1.01 * (i / 25), 1.01 * (i / 5 % 5))),
                  mass(1.0 * kilogram));
    for (int i = 0; i < steps; ++i) world.step(1.0 / 60 * second);
    return world.position(world.body_at(3)).value()[1];
}

int main([[maybe_unused]] int count, char**) {
    using Spheres = Narrowphase<Sphere, Plane>;
    double sum = 0;
#ifndef ANSATZ_ONLY_IMPULSE
    sum += pile(60, SemiImplicitEuler{}, Gravity{}, UniformGrid<>{}, Spheres{}, SoftSubsteps<>{});
#endif
#ifndef ANSATZ_ONLY_SUBSTEPS
    sum += pile(60, SemiImplicitEuler{}, Gravity{}, UniformGrid<>{}, Spheres{}, Impulse{}, Projection{});
#endif
#ifdef ANSATZ_EIGHT
    if (count > 5) {
        sum += pile(count, VelocityVerlet{}, Gravity{}, UniformGrid<>{}, Spheres{}, SoftSubsteps<>{});
        sum += pile(count, SemiImplicitEuler{}, Gravity{}, Drag{}, BoundingBoxes{}, Narrowphase<Sphere, Plane, Box>{},
                    Impulse{}, Projection{});
        sum += pile(count, Verlet{}, Gravity{}, AllPairs{}, Spheres{}, Projection{});
        sum += pile(count, SemiImplicitEuler{}, Gravity{}, Rest{}, SortAndSweep{}, Spheres{}, SoftSubsteps<Friction>{});
        sum += pile(count, RungeKutta4{}, Gravity{}, Springs<>{}, UniformGrid<>{}, Spheres{}, Impulse{});
        sum += pile(count, SemiImplicitEuler{}, Gravity{}, Springs<>{}, BoundingBoxes{}, Spheres{}, Penalty{});
        sum += pile(count, ExplicitEuler{}, Gravity{}, Rest{}, AllPairs{}, Spheres{}, Impulse{}, Projection{});
    }
#endif
    return sum > 1e9;
}
