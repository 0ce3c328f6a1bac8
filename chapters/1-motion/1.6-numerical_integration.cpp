// SPDX-License-Identifier: BSL-1.0
// 1.6 Numerical integration: one time step after another, and what its length costs

// A computer cannot follow a ball through every instant. It takes steps of length dt = t_{x+1} - t_x, and within one
// step it pretends that something is constant: explicit Euler the velocity, Verlet the acceleration, Runge and Kutta a
// polynomial. What is left out makes the error of one step; how fast that error falls when the step is made shorter is
// the *order* of the method. Halve the step, and a method of order one is twice as accurate, order two four times,
// order four sixteen times. This program drops the same body from the same height in the air with three integrators and
// measures exactly that.

#include "claims.hpp"
#include "plot.hpp"
#include "problems.hpp"

#include <ansatz/world.hpp>

#include <cmath>
#include <iostream>
#include <vector>

using namespace ansatz;
using workbook::Claims;

const auto fall_time = 5.0 * second;
const auto terminal = 50.0 * metre_per_second;

/// How far from the closed form the body ends, after a fall of five seconds in steps of dt.
//! [error]
template <class Integrator> Quantity<unit::Length> error(Quantity<unit::Time> dt, int steps) {
    World world{Integrator{}, Gravity{},
                QuadraticDrag::with_terminal_speed(terminal, 1.0 * kilogram, 9.81 * metre_per_second_squared)};
    const auto body = world.add(mass(1.0 * kilogram));
    for (int i = 0; i < steps; ++i) world.step(dt);
    const auto exact = problems::fall_with_quadratic_drag(terminal, 9.81 * metre_per_second_squared, fall_time);
    return abs(exact.x + y(world.position(body)));
}
//! [error]

template <class Integrator> double measured_order(const char* name, workbook::Plot& plot) {
    std::vector<Quantity<unit::Time>> steps;
    std::vector<Quantity<unit::Length>> errors;
    std::cout << "  " << name << '\n';
    for (int n = 50; n <= 400; n *= 2) {
        steps.push_back(fall_time / double(n));
        errors.push_back(error<Integrator>(steps.back(), n));
        std::cout << "    dt = " << steps.back() << ", error " << errors.back() << '\n';
    }
    plot.linked_points(name, steps, errors);
    return std::log2(double(errors[errors.size() - 2] / errors.back()));
}

int main() {
    std::cout << "A fall of five seconds through air (terminal speed 50 m/s):\n";
    workbook::Plot plot("1.6", "Halving the step: what each order gains");
    plot.x("time step").y("error of the position").log_x().log_y();

    const double euler = measured_order<SemiImplicitEuler>("semi-implicit Euler", plot);
    const double verlet = measured_order<VelocityVerlet>("velocity Verlet", plot);
    const double runge_kutta = measured_order<RungeKutta4>("Runge-Kutta 4", plot);
    std::cout << "Orders, measured between the last two steps: " << euler << ", " << verlet << ", " << runge_kutta
              << '\n';

    Claims claim;
    claim("semi-implicit Euler: half the step, half the error (order 1)", std::abs(euler - 1) < 0.05);
    claim("velocity Verlet: half the step, a quarter of the error (order 2)", std::abs(verlet - 2) < 0.05);
    claim("Runge-Kutta 4: half the step, a sixteenth of the error (order 4)", std::abs(runge_kutta - 4) < 0.1);
    plot.write();
    return claim.result();
}
