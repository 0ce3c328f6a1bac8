// SPDX-License-Identifier: BSL-1.0
// 1.7 Drag: a factor for each frame depends on the frame rate; a rate for each second does not

// The notes multiply the velocity by a factor 0 < d < 1 in each physics frame. The same game then feels different on a
// faster machine: 0.99 for each frame leaves 74 % of a velocity after a second at 30 Hz, 55 % at 60 Hz and 30 % at 120
// Hz. Multiply by exp(-c dt) instead, which is the same wish said for each second, and the frame rate disappears. The
// notes also vary the factor as a cheap change of environment; in a World that is one `set`. And what air really does,
// a force that grows with the square of the speed, gives a falling body a terminal speed.

#include "claims.hpp"
#include "columns.hpp"
#include "plot.hpp"
#include "problems.hpp"
#include "say.hpp"

#include <ansatz/world.hpp>

#include <cmath>
#include <iostream>
#include <vector>

using namespace ansatz;

/// What is left of 1 m/s after a second.
//! [left]
template <class Damping> double left_after_a_second(int rate, Damping damping) {
    World world{SemiImplicitEuler{}, damping};
    const auto body = world.add(velocity(metres_per_second(1, 0, 0)));
    for (int i = 0; i < rate; ++i) world.step(1.0 / rate * second);
    return in(x(world.velocity(body)), metre_per_second);
}
//! [left]

int main() {
    workbook::Claims claim;
    const double f30 = left_after_a_second(30, FrameDrag{0.99}), f60 = left_after_a_second(60, FrameDrag{0.99}),
                 f120 = left_after_a_second(120, FrameDrag{0.99});

    //! [rate]
    const auto rate = -60 * std::log(0.99) / second; // the same drag as 0.99 for each frame at 60 Hz
    const double d30 = left_after_a_second(30, Drag{rate}), d60 = left_after_a_second(60, Drag{rate}),
                 d120 = left_after_a_second(120, Drag{rate});
    //! [rate]
    std::cout << workbook::Columns({"left of a velocity after a second", "at 30 steps", "at 60 steps", "at 120 steps"})
                     .row("FrameDrag{0.99}", f30, f60, f120)
                     .row("Drag{0.603 / second}", d30, d60, d120);
    claim("a factor for each frame: 0.740, 0.547, 0.299 of the velocity",
          std::abs(f30 - 0.740) < 1e-3 && std::abs(f60 - 0.547) < 1e-3 && std::abs(f120 - 0.299) < 1e-3);
    claim("a rate for each second: the same at every frame rate",
          std::abs(d30 - d60) < 1e-9 && std::abs(d60 - d120) < 1e-9);

    // Another environment: the same body, first in air, then in honey.
    //! [honey]
    World bath{SemiImplicitEuler{}, Drag{0.1 / second}};
    const auto spoon = bath.add(velocity(metres_per_second(1, 0, 0)));
    for (int i = 0; i < 60; ++i) bath.step(1.0 / 60 * second);
    const auto in_air = norm(bath.velocity(spoon));
    bath.set(Drag{20.0 / second});
    //! [honey]
    for (int i = 0; i < 60; ++i) bath.step(1.0 / 60 * second);
    std::cout << "After a second in air " << in_air << ", after one more in honey " << norm(bath.velocity(spoon))
              << '\n';
    claim("varying the coefficient changes the environment",
          in_air > 0.9 * metre_per_second && norm(bath.velocity(spoon)) < 1e-8 * metre_per_second);

    // What air does.
    const auto g = 9.81 * metre_per_second_squared;
    const auto terminal = 50.0 * metre_per_second;
    //! [air]
    World sky{VelocityVerlet{}, Gravity{}, QuadraticDrag::with_terminal_speed(terminal, 80.0 * kilogram, g)};
    const auto diver = sky.add(mass(80.0 * kilogram));
    //! [air]
    std::vector<Quantity<unit::Time>> times;
    std::vector<Quantity<unit::Velocity>> speeds;
    for (int i = 0; i <= 20 * 240; ++i) {
        times.push_back(sky.time());
        speeds.push_back(norm(sky.velocity(diver)));
        sky.step(1.0 / 240 * second);
    }
    const auto at_5 = speeds[5 * 240];
    workbook::say() << "A fall in air: " << at_5 << " after 5 s (exact: 37.674924 m/s), " << speeds.back()
                    << " after 20 s (exact: 49.960962 m/s)\n";
    claim("quadratic drag follows v_t tanh(g t / v_t)",
          abs(at_5 - 37.674924 * metre_per_second) < 1e-4 * metre_per_second &&
              abs(speeds.back() - 49.960962 * metre_per_second) < 1e-4 * metre_per_second);
    workbook::Plot plot("1.7", "Air gives a fall its terminal speed");
    plot.x("time").y("speed");
    plot.line("with quadratic drag", times, speeds)
        .reference("without air", std::vector(times.begin(), times.begin() + 6 * 240),
                   [&](const auto& t) { return g * t; })
        .horizontal(terminal, "terminal speed")
        .write();
    return claim.result();
}
