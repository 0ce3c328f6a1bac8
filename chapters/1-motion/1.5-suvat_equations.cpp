// SPDX-License-Identifier: BSL-1.0
// 1.5 SUVAT equations: three of the five quantities give the other two, twice where a parabola is met twice

// v = u + a t,  s = u t + a t^2 / 2,  s = (u + v) t / 2,  v^2 = u^2 + 2 a s,  s = v t - a t^2 / 2. In the last one v is
// the *final* velocity; with the initial one it is wrong. The notes call a constant acceleration no issue, since a time
// step is small: true, and this assumption is what gives every method of 1.6 its order. The program ends with what it
// costs.

#include "claims.hpp"
#include "plot.hpp"
#include "say.hpp"

#include <ansatz/world.hpp>

#include <iostream>
#include <stdexcept>
#include <vector>

using namespace ansatz;

int main() {
    workbook::Claims claim;
    const auto g = -9.81 * metre_per_second_squared;

    // A ball leaves the roof (20 m) upwards. When does it land, and how fast?
    //! [roof]
    const auto throws = suvat::solve(suvat::displacement(-20.0 * metre),
                                     suvat::initial_velocity(5.0 * metre_per_second), suvat::acceleration(g));
    //! [roof]
    std::cout << "Thrown up from the roof it lands after " << throws.back().t << " with " << throws.back().v << '\n';
    claim("it lands after 2.592 s", abs(throws.back().t - 2.59229 * second) < 1e-5 * second);
    claim("the other root is the same parabola, before the throw",
          throws.size() == 2 && throws.front().t < 0.0 * second);

    // It passes a window at 21 m twice: the notes' fourth equation has two roots.
    const auto window = suvat::solve(suvat::displacement(1.0 * metre), suvat::initial_velocity(5.0 * metre_per_second),
                                     suvat::acceleration(g));
    for (const auto& pass : window) std::cout << "It passes the window after " << pass.t << " with " << pass.v << '\n';
    claim("up and down with the same speed", window.front().v == -window.back().v);

    // A question without an answer is refused, and says why.
    std::string reason;
    //! [refused]
    try {
        suvat::solve(suvat::displacement(2.0 * metre), suvat::initial_velocity(5.0 * metre_per_second),
                     suvat::acceleration(g));
    } catch (const std::invalid_argument& error) {
        reason = error.what();
    }
    //! [refused]
    workbook::say() << "Does it reach 22 m? " << reason << '\n';
    claim("out of reach is a sentence, not a NaN", !reason.empty());

    // s = v t - a t^2 / 2 with the initial velocity instead of the final one: from rest with 2 m/s^2 for 3 s.
    const auto u = 0.0 * metre_per_second;
    const auto a = 2.0 * metre_per_second_squared;
    const auto t = 3.0 * second;
    const auto start = suvat::solve(suvat::initial_velocity(u), suvat::acceleration(a), suvat::time(t)).front();
    workbook::say() << "From rest, 2 m/s^2 for 3 s: " << start.s << "; v t - a t^2 / 2 with v = " << start.v
                    << " gives " << start.v * t - 0.5 * a * t * t << ", with the initial velocity "
                    << u * t - 0.5 * a * t * t << '\n';
    claim("the final velocity belongs in the fifth equation", start.v * t - 0.5 * a * t * t == start.s);

    // Constant acceleration within a step: a spring's changes, so each step of u, a, t -> s, v has an error that adds
    // up.
    std::vector<double> steps, errors;
    for (const int n : {16, 32, 64, 128}) {
        const auto dt = 1.0 / n * second;
        auto place = 1.0 * metre;
        auto velocity = 0.0 * metre_per_second;
        for (int i = 0; i < n; ++i) {
            //! [within]
            const auto within = suvat::solve(suvat::initial_velocity(velocity),
                                             suvat::acceleration(-place / (second * second)), suvat::time(dt))
                                    .front();
            place += within.s;
            velocity = within.v;
            //! [within]
        }
        steps.push_back(in(dt, second));
        errors.push_back(std::abs(in(place, metre) - std::cos(1.0)));
    }
    workbook::say() << "A spring of 1 s, by SUVAT steps: error " << errors[0] << " m with 16 of them, " << errors[3]
                    << " m with 128\n";
    const double order = std::log2(errors[2] / errors[3]);
    claim("halving the step halves the error: order 1", order > 0.9 && order < 1.1);

    std::vector<Quantity<unit::Time>> times;
    std::vector<Quantity<unit::Length>> heights;
    for (int i = 0; i <= 60; ++i) {
        const auto at = i / 60.0 * throws.back().t;
        times.push_back(at);
        heights.push_back(20.0 * metre + suvat::solve(suvat::initial_velocity(5.0 * metre_per_second),
                                                      suvat::acceleration(g), suvat::time(at))
                                             .front()
                                             .s);
    }
    const std::vector passes{window.front().t, window.back().t};
    workbook::Plot plot("1.5", "One height, two moments: both roots are motions");
    plot.x("time").y("height").line("thrown up from a roof", times, heights);
    plot.points("at 21 m", passes, std::vector(2, 21.0 * metre)).write();
    return claim.result();
}
