// SPDX-License-Identifier: BSL-1.0
// 1.6.4 Verlet: the velocity is in the history of positions, and time can be run backwards

// Put v = (s_x - s_{x-1}) / dt into Euler's equations and the velocity disappears: s_{x+1} = s_x + (s_x - s_{x-1}) + a
// dt^2. Three things that the notes leave out decide whether this is a good method:
// - The start. There is no s_{-1}; it must be made as s_0 - v_0 dt + a_0 dt^2 / 2. Without the last term the method is
// of
//   first order, and with s_{-1} = s_0 it computes the path of a body that started at rest.
// - The velocity (s_x - s_{x-1}) / dt belongs to half a step ago. World::velocity brings it to the present.
// - "Reversible" holds without damping, for a fixed step and forces of position.

#include "claims.hpp"
#include "oscillation.hpp"
#include "plot.hpp"

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
    std::cout << "Orders of the three starts: with a dt^2/2 " << order(library) << ", without " << order(first_order)
              << ", with s_{-1} = s_0 " << order(from_rest) << " (error stays at " << from_rest.back() << ")\n";
    claim("started with s_0 - v_0 dt + a_0 dt^2 / 2, Verlet is of second order", std::abs(order(library) - 2) < 0.02);
    claim("without the last term it is of first order", std::abs(order(first_order) - 1) < 0.05);
    claim("started with s_{-1} = s_0 it does not converge at all", from_rest.back() > 0.2 * metre);

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
