// SPDX-License-Identifier: BSL-1.0
// 1.6.3 Semi-implicit Euler: explicit Euler with two lines swapped, and the energy stays

// Update the velocity first and move with the *new* one: that is the whole difference to explicit Euler, it costs
// nothing, and it makes the method symplectic. Its energy is not exact, it swings about the true one, but it never
// drifts: what it keeps exactly is a neighbouring energy, H~ = v^2/2 + w^2 x^2/2 - dt w^2 x v / 2.
//
// "Stable", say the notes. For a spring this means omega dt < 2, and not a hair more. Explicit damping makes the limit
// smaller: with a_damping = -c v it is (sqrt(c^2 + 4 w^2) - c) / w^2.

#include "claims.hpp"
#include "oscillation.hpp"
#include "plot.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>

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

    std::cout << "The limit omega dt = 2: within 2000 steps the mass reaches " << reach(1.999) << " m at 1.999, "
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
