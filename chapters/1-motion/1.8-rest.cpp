// SPDX-License-Identifier: BSL-1.0
// 1.8 Rest: "velocity close to zero" alone stops a ball in mid-air; rest takes time and nothing that pulls

// The notes set a velocity close to zero to zero, to save work. Taken to the letter (policy StopBelow) this does two
// wrong things: it saves nothing, since the body is computed in the next step all the same, and it stops a ball at the
// top of its flight. In a world of weak gravity, where one step adds less than the threshold, the ball only creeps on,
// by g dt^2 in a step, for ever. The policy Rest asks for more: slow for a while, and at velocity zero nothing may
// pull. Such a body leaves the range that the step walks, so that it costs nothing, and anything that touches it wakes
// it.

#include "claims.hpp"
#include "plot.hpp"
#include "say.hpp"

#include <ansatz/world.hpp>

#include <iostream>
#include <vector>

using namespace ansatz;

struct Flight {
    std::vector<Quantity<unit::Time>> times;
    std::vector<Quantity<unit::Length>> heights;
};

/// A ball thrown upwards with 1 m/s on a small moon (g = 0.1 m/s^2), for 20 s.
template <class Resting> Flight throw_up(Resting rest) {
    //! [moon]
    World moon{SemiImplicitEuler{}, Gravity{metres_per_second_squared(0, -0.1, 0)}, rest};
    const auto ball = moon.add(velocity(metres_per_second(0, 1, 0)));
    //! [moon]
    Flight flight;
    for (int i = 0; i <= 20 * 60; ++i) {
        flight.times.push_back(moon.time());
        flight.heights.push_back(y(moon.position(ball)));
        moon.step(1.0 / 60 * second);
    }
    return flight;
}

int main() {
    workbook::Claims claim;
    //! [rules]
    const auto naive = throw_up(StopBelow{0.05 * metre_per_second});
    const auto safe = throw_up(Rest{0.05 * metre_per_second, 0.5 * second});
    //! [rules]
    std::cout << "Thrown up on a small moon; after 20 s it should be back at 0 m.\n"
              << "  the notes' rule:  " << naive.heights.back() << " (it hangs near the top of its flight, 5 m)\n"
              << "  Rest:             " << safe.heights.back() << '\n';
    claim("the notes' rule stops the ball near the top of its flight", naive.heights.back() > 4.9 * metre);
    claim("Rest lets it come down again", safe.heights.back() < 0.1 * metre);

    //! [puck]
    World ice{SemiImplicitEuler{}, Rest{}, Drag{1.0 / second}, AppliedForces{}};
    const auto puck = ice.add(velocity(metres_per_second(1, 0, 0)), mass(0.2 * kilogram));
    Quantity<unit::Time> slept_at{};
    while (ice.time() < 10.0 * second) {
        ice.step(1.0 / 60 * second);
        for (const auto& event : ice.events())
            if (event.kind == Event::Kind::slept) slept_at = ice.time();
    }
    //! [puck]
    workbook::say() << "A puck on rough ice fell asleep after " << slept_at << "; it is now "
                    << name_of(ice.motion(puck)) << ", velocity " << ice.velocity(puck) << '\n';
    claim("a body that is slow for half a second, and that nothing pulls, rests", ice.motion(puck) == Motion::resting);
    claim("its velocity is exactly zero", ice.velocity(puck) == metres_per_second(0, 0, 0));
    //! [push]
    ice.apply_force(puck, newtons(0, 0, 1));
    ice.step(1.0 / 60 * second);
    //! [push]
    std::cout << "Pushed, it is " << name_of(ice.motion(puck)) << ", velocity " << ice.velocity(puck) << '\n';
    claim("a force wakes it within the step",
          ice.motion(puck) == Motion::awake && z(ice.velocity(puck)) > 0.0 * metre_per_second);

    workbook::Plot plot("1.8", "Speed alone puts a thrown ball to rest in mid-air");
    plot.x("time")
        .y("height")
        .line("velocity close to zero set to zero", naive.times, naive.heights)
        .line("Rest", safe.times, safe.heights)
        .write();
    return claim.result();
}
