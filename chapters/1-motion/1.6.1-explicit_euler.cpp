// SPDX-License-Identifier: BSL-1.0
// 1.6.1 Explicit Euler: simple, cheap, and unstable for anything that swings, at every step length

// The notes call explicit Euler "unstable at high dt". For a swinging mass it is worse than that: with
// v' = v - w^2 x dt and x' = x + v dt, the energy of the new state is exactly (1 + (w dt)^2) times that of the old one.
// The factor is above one for *every* dt, so a shorter step only makes the explosion slower. This program lets a mass
// on a spring swing for three seconds and holds the energy against that factor.

#include "claims.hpp"
#include "oscillation.hpp"
#include "plot.hpp"
#include "say.hpp"

#include <cmath>
#include <iostream>

using namespace ansatz;

int main() {
    const auto omega = 10.0 / second;
    workbook::say() << "A mass on a spring, omega = " << omega
                    << ", for 3 s. Energy at the end, as a multiple of that at the start:\n";
    workbook::Plot plot("1.6.1", "Explicit Euler gains energy at every step, however short");
    plot.x("time").y("energy per mass").log_y();
    workbook::Claims claim;
    for (const int rate : {60, 120, 240, 1000}) {
        const auto dt = 1.0 / rate * second;
        const int steps = 3 * rate;
        //! [growth]
        const auto run = problems::oscillate<ExplicitEuler>(omega, dt, steps);
        const double measured = run.energies.back() / run.energies.front();
        const double step_angle = omega * dt;
        const double predicted = std::pow(1 + step_angle * step_angle, steps);
        //! [growth]
        std::cout << "  " << rate << " steps/s: measured " << measured << ", (1 + (w dt)^2)^n = " << predicted << '\n';
        plot.line(std::to_string(rate) + " steps/s", run.times, run.energies);
        claim("the energy has grown by the factor (1 + (w dt)^2) in each step",
              std::abs(measured / predicted - 1) < 1e-9);
        claim("it has grown, although " + std::to_string(rate) + " steps a second were taken", measured > 1);
    }
    plot.write();
    workbook::say() << "A body that only falls does not explode, but it is always a little too high, by g dt t / 2:\n";
    //! [fall]
    World world{ExplicitEuler{}, Gravity{}};
    const auto body = world.add(position(metres(0, 0, 0)));
    for (int i = 0; i < 60; ++i) world.step(1.0 / 60 * second);
    const auto offset = y(world.position(body)) + 0.5 * 9.81 * metre_per_second_squared * (1.0 * second * second);
    //! [fall]
    std::cout << "  after 1 s at 60 Hz: " << offset << " too high\n";
    claim("which is +0.08175 m here", abs(offset - 0.08175 * metre) < 1e-12 * metre);
    return claim.result();
}
