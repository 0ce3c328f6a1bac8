// SPDX-License-Identifier: BSL-1.0
#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>
#include <iostream>
using namespace ansatz;

int main() {
    World pool{SemiImplicitEuler{}, // how bodies move
               Gravity{},
               Rest{},                       // bodies that lie still fall asleep
               SortAndSweep{},               // which pairs may touch
               Narrowphase<Sphere, Plane>{}, // which do, and where
               Impulse{},                    // what it does to velocities
               Projection{}};                // and to positions
    pool.add(Plane::ground(), fixed);
    auto ball = pool.add(Sphere{0.5 * metre}, position(metres(0, 10, 0)), mass(2.0 * kilogram), restitution(0.8));
    for (int i = 0; i < 600; ++i) pool.step(1.0 / 60 * second);
    std::cout << pool.position(ball) << '\n'; // prints with its unit
}
