// SPDX-License-Identifier: BSL-1.0
// 3.2 Two bodies and a spring: what one feels the other feels, and the pair swings with its reduced mass

// A spring between two bodies pulls at both, with opposite signs (notes 1.3), so nothing inside the pair moves its
// centre of mass. Seen from each other the two behave like one mass on a spring: mu = m M / (m + M). When one is much
// heavier, mu is the light one, and the spring might as well hang at a wall. (A part of section 3, which the notes do
// not divide.)

#include "claims.hpp"
#include "plot.hpp"

#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

#include <cmath>
#include <iostream>
#include <vector>

using namespace ansatz;

int main() {
    workbook::Claims claim;
    const auto k = 100.0 * newton_per_metre;
    const auto light = 1.0 * kilogram, heavy = 3.0 * kilogram;

    //! [pair]
    World space{VelocityVerlet{}, Springs<Undamped>{}};
    const auto a = space.add(position(metres(0, 0, 0)), velocity(metres_per_second(0.5, 0, 0)), mass(light));
    const auto b = space.add(position(metres(1.4, 0, 0)), mass(heavy));
    space.add(Spring{a, b, k, {}, 1.0 * metre});
    //! [pair]
    const auto momentum = total_momentum(space);
    const auto energy = total_energy(space);
    std::vector<Quantity<unit::Time>> times;
    std::vector<Quantity<unit::Length>> first, second_, centre;
    double swing = 0, last = 0;
    std::vector<double> crossings; // when the spring passes its rest length, getting longer
    while (space.time() < 3.0 * second) {
        times.push_back(space.time());
        first.push_back(x(space.position(a)));
        second_.push_back(x(space.position(b)));
        centre.push_back(x(centre_of_mass(space)));
        space.step(1.0 / 1000 * second);
        const double stretched = x(space.position(b) - space.position(a)) / metre - 1;
        if (times.size() > 1 && last < 0 && stretched >= 0)
            crossings.push_back(space.time() / second - 0.001 * stretched / (stretched - last));
        last = stretched;
        swing = std::max<double>(swing, std::abs(total_energy(space) / energy - 1));
    }
    const double measured = (crossings.back() - crossings.front()) / double(crossings.size() - 1);
    //! [period]
    const auto mu = springs::reduced_mass(light, heavy);
    const auto period = 1.0 / springs::frequency(k, mu);
    //! [period]
    std::cout << "Reduced mass " << mu << ": one swing should take " << period << ", and takes " << measured << " s\n";
    claim("the pair swings with its reduced mass", std::abs(measured / in(period, second) - 1) < 1e-4);
    std::cout << "Momentum before " << momentum << ", after " << total_momentum(space) << '\n';
    claim("the spring gives the pair no momentum",
          norm(total_momentum(space) - momentum) < 1e-12 * kilogram_metre_per_second);
    claim("the centre of mass goes straight on",
          abs(centre.back() - centre.front() - times.back() * (momentum.value()[0] / 4) * metre_per_second) <
              1e-12 * metre);
    claim("the energy swings by less than (omega dt)^2 and does not drift", swing < 2e-4);
    claim("beside a mountain, the reduced mass is the light one",
          abs(springs::reduced_mass(light, 1e9 * kilogram) - light) < 1e-8 * kilogram);

    workbook::Plot plot("3.2", "Two bodies on a spring swing about a centre that goes straight on");
    plot.x("time").y("place");
    plot.line("1 kg", times, first).line("3 kg", times, second_).reference("centre of mass", times, centre).write();
    return claim.result();
}
