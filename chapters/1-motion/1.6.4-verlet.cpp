// SPDX-License-Identifier: BSL-1.0
// 1.6.4 Verlet: the velocity is in the history of positions, and time can be run backwards

// Put v = (s_x - s_{x-1}) / dt into Euler's equations and the velocity disappears: s_{x+1} = s_x + (s_x - s_{x-1}) + a
// dt^2. Four things that the notes leave out decide whether this is a good method:
// - The start. There is no s_{-1}; it must be made as s_0 - v_0 dt + a_0 dt^2 / 2. Without the last term the method is
// of
//   first order, and with s_{-1} = s_0 it computes the path of a body that started at rest.
// - The velocity (s_x - s_{x-1}) / dt belongs to half a step ago. World::velocity brings it to the present.
// - A step that changes: s_x - s_{x-1} was the way of the old step, and must be carried to the new one.
// - "Reversible" holds without damping, for a fixed step and forces of position.

#include "claims.hpp"
#include "oscillation.hpp"
#include "plot.hpp"
#include "say.hpp"

#include <cmath>
#include <iostream>
#include <vector>

using namespace ansatz;

const auto omega = 1.0 / second;
const problems::OnALine start{1.0 * metre, 0.5 * metre_per_second};
const auto duration = 10.0 * second;

/// The error after ten seconds of the recursion by hand, from a given s_{-1}.
//! [recursion]
Quantity<unit::Length> by_hand(int n, Quantity<unit::Length> before, Quantity<unit::Time> dt) {
    auto now = start.x;
    for (int i = 0; i < n; ++i) {
        const auto next = now + (now - before) - omega * omega * now * dt * dt;
        before = now;
        now = next;
    }
    return abs(now - problems::oscillator(omega, start, duration).x);
}
//! [recursion]

/// Steps of h, 2h, h, 2h and so on, by hand, with omega = 1/s: the error after ten seconds, m, and two velocities
/// there.
struct Uneven {
    double error, mean_velocity_error, velocity_error; // m, m/s, m/s
};
//! [uneven]
Uneven uneven(int n, bool carried) {
    const double h = 10.0 / (1.5 * n), x0 = 1, v0 = 0.5;
    double x = x0, old_dt = h, t = 0, before = x0 - v0 * h - 0.5 * x0 * h * h; // a = -x
    for (int i = 0; i < n; ++i) {
        const double dt = i % 2 ? h : 2 * h;
        const double next = carried ? x + (x - before) * dt / old_dt - x * dt * (dt + old_dt) / 2 // as it should be
                                    : x + (x - before) - x * dt * dt;                             // the notes'
        before = x, x = next, old_dt = dt, t += dt;
    }
    const double v = v0 * std::cos(t) - x0 * std::sin(t), mean = (x - before) / old_dt;
    return {std::abs(x - x0 * std::cos(t) - v0 * std::sin(t)), std::abs(mean - v),
            std::abs(mean - 0.5 * x * old_dt - v)}; // half a step of a brings it to the present
}
//! [uneven]

int main() {
    workbook::Claims claim;
    std::vector<Quantity<unit::Time>> steps;
    std::vector<Quantity<unit::Length>> library, first_order, from_rest;
    for (int n = 100; n <= 1600; n *= 2) {
        const auto dt = duration / double(n);
        steps.push_back(dt);
        const auto exact = problems::oscillator(omega, start, duration).x;
        //! [starts]
        library.push_back(abs(problems::oscillate<Verlet>(omega, dt, n, start.v).places.back() - exact));
        first_order.push_back(by_hand(n, start.x - start.v * dt, dt));
        from_rest.push_back(by_hand(n, start.x, dt));
        //! [starts]
    }
    auto order = [](const auto& errors) { return std::log2(double(errors[errors.size() - 2] / errors.back())); };
    workbook::say() << "Orders of the three starts: with a dt^2/2 " << order(library) << ", without "
                    << order(first_order) << ", with s_{-1} = s_0 " << order(from_rest) << " (error stays at "
                    << from_rest.back() << ")\n";
    claim("started with s_0 - v_0 dt + a_0 dt^2 / 2, Verlet is of second order", std::abs(order(library) - 2) < 0.02);
    claim("without the last term it is of first order", std::abs(order(first_order) - 1) < 0.05);
    claim("started with s_{-1} = s_0 it does not converge at all", from_rest.back() > 0.2 * metre);

    const auto log2 = [](double coarse, double fine) { return std::log2(coarse / fine); };
    const auto coarse = uneven(800, true), fine = uneven(1600, true);
    const double by_the_notes = uneven(1600, false).error;
    workbook::say() << "Steps of h and 2h in turn: order " << log2(coarse.error, fine.error)
                    << " if the velocity is carried over, error " << by_the_notes << " m if not\n"
                    << "Order of the velocity: (s_x - s_{x-1}) / dt "
                    << log2(coarse.mean_velocity_error, fine.mean_velocity_error) << ", half a step later "
                    << log2(coarse.velocity_error, fine.velocity_error) << '\n';
    claim("with steps that vary it is of second order, if the velocity is carried over",
          std::abs(log2(coarse.error, fine.error) - 2) < 0.05);
    claim("by the notes' formula it does not converge then",
          by_the_notes > 0.1 && std::abs(log2(uneven(800, false).error, by_the_notes)) < 0.1);
    claim("the difference of two positions is the velocity to first order, with half a step of a to second",
          std::abs(log2(coarse.mean_velocity_error, fine.mean_velocity_error) - 1) < 0.05 &&
              std::abs(log2(coarse.velocity_error, fine.velocity_error) - 2) < 0.05);

    workbook::Plot plot("1.6.4", "The start of the history decides the order");
    plot.x("time step").y("error after 10 s").log_x().log_y();
    plot.linked_points("s_{-1} = s_0", steps, from_rest)
        .linked_points("s_0 - v_0 dt", steps, first_order)
        .linked_points("s_0 - v_0 dt + a_0 dt^2/2", steps, library)
        .write();

    // Backwards: swap the last two positions and go on. Here the velocity is turned round, which is the same thing.
    //! [back]
    World world{Verlet{}, problems::Oscillator{omega}};
    const auto body = world.add(position(metres(1, 0, 0)), velocity(metres_per_second(0.5, 0, 0)));
    for (int i = 0; i < 10000; ++i) world.step(0.01 * second);
    world.set_velocity(body, -world.velocity(body));
    for (int i = 0; i < 10000; ++i) world.step(0.01 * second);
    const auto missed = norm(world.position(body) - metres(1, 0, 0));
    //! [back]
    std::cout << "10000 steps forth and 10000 back: " << missed << " from the start\n";
    claim("run backwards, it returns to where it began", missed < 1e-10 * metre);

    std::cout << "Bytes of a body: " << World<Verlet>::bytes_per_body << " with history, "
              << World<SemiImplicitEuler>::bytes_per_body << " with velocity\n";
    claim("the history costs as much room as the velocity that it replaces",
          World<Verlet>::bytes_per_body == World<SemiImplicitEuler>::bytes_per_body);
    return claim.result();
}
