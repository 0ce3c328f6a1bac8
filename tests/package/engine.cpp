// SPDX-License-Identifier: BSL-1.0
#include <ansatz/world.hpp>
#include <iostream>
using namespace ansatz;

int main() {
    World sky{SemiImplicitEuler{}, Gravity{}, QuadraticDrag{0.02 * kilogram_per_metre}, Interpolation{}};
    auto ball = sky.add(position(metres(0, 10, 0)), velocity(metres_per_second(3, 0, 0)), mass(0.5 * kilogram));

    FixedStep clock{1.0 / 60 * second};
    for (int frame = 0; frame < 72; ++frame) { // a display of 72 Hz
        clock.advance(sky, 1.0 / 72 * second);
        if (frame % 12 == 0) std::cout << interpolated_position(sky, ball, clock.alpha()) << '\n';
    }

    World snapshot = sky;                                     // a world is a value
    sky.set(Gravity{metres_per_second_squared(0, -1.62, 0)}); // from here on we are on the moon
    sky.apply_impulse(ball, newton_seconds(0, 4, 0));         // kicked upwards
    for (int i = 0; i < 60; ++i) sky.step(1.0 / 60 * second);
    std::cout << sky.time() << ": " << sky.position(ball) << ", " << kinetic_energy(sky) << '\n'
              << snapshot.time() << ": " << snapshot.position(ball) << ", " << kinetic_energy(snapshot) << '\n';
}
