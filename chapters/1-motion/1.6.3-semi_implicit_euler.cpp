// SPDX-License-Identifier: BSL-1.0
// 1.6.3 Semi-implicit Euler: explicit Euler with two lines swapped, and the energy stays

// Update the velocity first and move with the *new* one: that is the whole difference to explicit Euler, it costs
// nothing, and it makes the method symplectic. Its energy is not exact, it swings about the true one, but it never
// drifts: what it keeps exactly is a neighbouring energy, H~ = v^2/2 + w^2 x^2/2 - dt w^2 x v / 2.
//
// "Stable", say the notes. For a spring this means omega dt < 2, and not a hair more. Explicit damping makes the limit
// smaller: with a_damping = -c v it is (sqrt(c^2 + 4 w^2) - c) / w^2.

#include "claims.hpp"
#include "film.hpp"
#include "oscillation.hpp"
#include "plot.hpp"
#include "say.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <string>

using namespace ansatz;

/// The largest excursion within 2000 steps of a spring with omega = 1/s.
//! [reach]
template <class... Damping> double reach(double dt, Damping... damping) {
    World world{SemiImplicitEuler{}, problems::Oscillator{1.0 / second}, damping...};
    const auto body = world.add(position(metres(1, 0, 0)));
    double most = 0;
    for (int i = 0; i < 2000; ++i) {
        world.step(dt * second);
        most = std::max(most, std::abs(in(x(world.position(body)), metre)));
    }
    return most;
}
//! [reach]

/// Masses on three equal springs are let go at half a metre, for the film; how far each swings in the last of four
/// seconds, over how far it was pulled.
std::array<double, 3> side_by_side() {
    workbook::Film film(
        "1.6.3", "One spring, three methods",
        "Three masses on equal springs are let go at the same place. By explicit Euler the swing grows, "
        "by semi-implicit Euler it stays, and by implicit Euler it dies away.",
        {.middle = metres(0, 0.1, 0), .width = 3.7 * metre, .height = 2.1 * metre});
    film.still(40);
    const auto swings = [](auto integrator) {
        World world{integrator, problems::Oscillator{4.0 / second}};
        const auto mass = world.add(position(metres(0.5, 0, 0)));
        std::vector<double> places;
        for (int n = 0; n <= 120; ++n, world.step(1.0 / 30 * second))
            places.push_back(in(x(world.position(mass)), metre));
        return places;
    };
    const std::array paths{swings(ExplicitEuler{}), swings(SemiImplicitEuler{}), swings(ImplicitEuler{})};
    const std::array names{"explicit Euler", "semi-implicit Euler", "implicit Euler"};
    for (std::size_t k = 0; k < 3; ++k) film.scenery().note(metres(-1.8, 1.0 - 0.7 * double(k), 0), names[k]);
    for (std::size_t n = 0; n <= 120; n += 2) {
        auto& frame = film.frame(double(n) / 30 * second);
        for (std::size_t k = 0; k < 3; ++k) {
            const double height = 0.75 - 0.7 * double(k);
            frame.line(std::vector{metres(-1.8, height, 0), metres(paths[k][n], height, 0)}, workbook::paints::wire)
                .ball(metres(paths[k][n], height, 0), 0.12 * metre, workbook::paints::ball);
        }
    }
    film.write();
    std::array<double, 3> swung{};
    for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t n = 90; n <= 120; ++n) swung[k] = std::max(swung[k], std::abs(paths[k][n]) / 0.5);
    return swung;
}

int main() {
    workbook::Claims claim;
    const auto omega = 10.0 / second;
    const auto dt = 1.0 / 60 * second;
    const auto run = problems::oscillate<SemiImplicitEuler>(omega, dt, 60000, 3.0 * metre_per_second);

    //! [shadow]
    auto shadow = [&](std::size_t i) {
        return run.energies[i] - 0.5 * dt * omega * omega * run.places[i] * run.velocities[i];
    };
    //! [shadow]
    double least = 1e9, most = 0, drift = 0;
    for (std::size_t i = 0; i < run.energies.size(); ++i) {
        least = std::min<double>(least, run.energies[i] / run.energies[0]);
        most = std::max<double>(most, run.energies[i] / run.energies[0]);
        drift = std::max<double>(drift, std::abs(double(shadow(i) / shadow(0)) - 1));
    }
    std::cout << "60000 steps: the energy swings between " << least << " and " << most << " of its start;\n"
              << "the neighbouring energy H~ is off by " << drift << " at most\n";
    claim("after 60000 steps the energy still swings about its start", most < 1.25 && least > 0.75);
    claim("what is kept exactly is H~, to rounding", drift < 1e-11);

    workbook::say() << "The limit omega dt = 2: within 2000 steps the mass reaches " << reach(1.999) << " m at 1.999, "
                    << reach(2.001) << " m at 2.001\n";
    claim("stable just below omega dt = 2", reach(1.999) < 100);
    claim("unstable just above", reach(2.001) > 1e9);

    //! [damped]
    const double c = 2, limit = std::sqrt(c * c + 4) - c;
    //! [damped]
    std::cout << "With explicit damping c = 2/s the limit is " << limit << " s instead of 2 s\n";
    claim("stable at 0.99 of it", reach(0.99 * limit, problems::LinearDamping{c / second}) < 100);
    claim("unstable at 1.01 of it: damping made the step smaller",
          reach(1.01 * limit, problems::LinearDamping{c / second}) > 1e9);

    const auto [grown, kept_up, faded] = side_by_side();
    workbook::say() << "After four seconds at 30 steps a second, omega = 4/s, a swing is " << grown
                    << " times as wide by explicit Euler, " << kept_up << " by semi-implicit, " << faded
                    << " by implicit Euler\n";
    claim("one line makes the difference between growing and staying", grown > 2.5 && std::abs(kept_up - 1) < 0.02);
    claim("and the implicit one loses it", faded < 0.5);

    const std::size_t shown = 240;
    const std::vector times(run.times.begin(), run.times.begin() + shown);
    workbook::Plot plot("1.6.3", "The energy swings, but never drifts");
    plot.x("time").y("energy per mass");
    plot.line("energy", times, std::vector(run.energies.begin(), run.energies.begin() + shown));
    std::vector<Quantity<unit::SpecificEnergy>> kept;
    for (std::size_t i = 0; i < shown; ++i) kept.push_back(shadow(i));
    plot.line("H~, which the method keeps", times, kept).write();
    return claim.result();
}
