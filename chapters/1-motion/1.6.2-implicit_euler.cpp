// SPDX-License-Identifier: BSL-1.0
// 1.6.2 Implicit Euler: stable at any step, because it solves for the next state; the price is a damping of its own

// Implicit Euler uses the rate of change in the state that it does not know yet, so it has to *solve* an equation in
// every step; for a spring that is what makes it "computationally expensive". It never grows: the energy is multiplied
// by 1 / (1 + (w dt)^2) in each step. That is the notes' "stable", and it is also a brake: at omega = 10/s and 60 Hz,
// four fifths of the energy are gone after a second in which nothing should have been lost.
//
// And it must really be solved. Guessing the next state, computing the acceleration there, and repeating that a few
// times looks like the same thing, but it converges only while w dt < 1, where no implicit method was needed. The
// second half shows such fixed-point iterations on a stiff spring beside Newton's method, which the library uses.

#include "claims.hpp"
#include "oscillation.hpp"
#include "plot.hpp"
#include "say.hpp"

#include <cmath>
#include <iostream>

using namespace ansatz;

/// What implicit Euler is not: the new state guessed and improved by repetition, a fixed number of times.
//! [fixed_point]
struct FixedPointEuler {
    using role = roles::Integrator;
    using writes = Columns<Position, Velocity>;

    static bool solve(auto& x, auto& v, const auto& laws, const auto& dt) {
        auto next = v;
        for (int iteration = 0; iteration < 5; ++iteration) next = v + laws(x + next * dt, next, 1.0) * dt;
        v = next;
        x += v * dt;
        return true;
    }
};
//! [fixed_point]

int main() {
    workbook::Claims claim;
    const auto omega = 10.0 / second;
    const auto dt = 1.0 / 60 * second;
    //! [solved]
    const auto run = problems::oscillate<ImplicitEuler>(omega, dt, 60);
    const double left = run.energies.back() / run.energies.front();
    const double step_angle = omega * dt;
    const double predicted = std::pow(1 + step_angle * step_angle, -60);
    //! [solved]
    workbook::say() << "omega = " << omega << ", 60 Hz: after a second " << 100 * left
                    << " % of the energy are left (predicted " << 100 * predicted << " %)\n";
    claim("the energy shrinks by 1 / (1 + (w dt)^2) in each step: 81 % are lost in a second",
          std::abs(left / predicted - 1) < 1e-12);

    const auto stiff = 1000.0 / second; // w dt = 16.7: any explicit method explodes
    const auto solved = problems::oscillate<ImplicitEuler>(stiff, dt, 60);
    std::cout << "A stiff spring (omega dt = 16.7): after a second the mass is at " << solved.places.back() << '\n';
    claim("solved, the stiff spring comes to rest instead of exploding", abs(solved.places.back()) < 1e-6 * metre);

    const auto harder = 100.0 / second; // w dt = 1.67
    const auto repeated = problems::oscillate<FixedPointEuler>(harder, dt, 60);
    const auto newton = problems::oscillate<ImplicitEuler>(harder, dt, 60);
    workbook::say() << "omega dt = 1.67, 60 steps: 5 iterations a step end at " << repeated.places.back()
                    << ", Newton's method at " << newton.places.back() << '\n';
    claim("five iterations are not a solution: beyond w dt = 1 they explode",
          abs(repeated.places.back()) > 1e30 * metre);
    claim("solved exactly, the same step is calm", abs(newton.places.back()) < 1e-15 * metre);

    const auto kept = problems::oscillate<SemiImplicitEuler>(omega, dt, 60);
    workbook::Plot plot("1.6.2", "Implicit Euler is stable, and brakes what should swing for ever");
    plot.x("time").y("displacement");
    plot.reference("exact", run.times,
                   [&](const auto& t) {
                       return problems::oscillator(omega, {1.0 * metre, 0.0 * metre_per_second}, t).x;
                   })
        .line("implicit Euler", run.times, run.places)
        .line("semi-implicit Euler", kept.times, kept.places)
        .write();
    return claim.result();
}
