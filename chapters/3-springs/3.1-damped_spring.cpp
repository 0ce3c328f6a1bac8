// SPDX-License-Identifier: BSL-1.0
// 3.1 The damped spring: it swings, it returns, or it creeps

// One number says which: zeta = c / (2 sqrt(k m)). Below 1 the mass swings about its rest, each swing smaller than the
// last; at 1 it returns fastest without swinging over; above 1 it creeps. The critical damping is 2 sqrt(k m), not
// sqrt(k m): with the half of it the mass still swings over. (A part of section 3, which the notes do not divide.)

#include "claims.hpp"
#include "film.hpp"
#include "plot.hpp"

#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

#include <array>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

using namespace ansatz;

namespace {

/// What a mass of 1 kg does on a spring that is described by how it should behave.
struct Run {
    std::vector<Quantity<unit::Time>> times;
    std::vector<Quantity<unit::Length>> places;
    double least = 0; ///< m; below zero it has swung over
};
//! [run]
Run run(double ratio) {
    const auto m = 1.0 * kilogram;
    const auto f = 1.0 * hertz; // swings per second, if it were not damped
    World world{VelocityVerlet{}, Springs{}};
    const auto body = world.add(position(metres(1.2, 0, 0)), mass(m));
    world.add(Spring{metres(0, 0, 0), body, springs::stiffness(f, m), springs::damping(f, ratio, m), 1.0 * metre});
    //! [run]
    Run result;
    while (world.time() < 3.0 * second) {
        result.times.push_back(world.time());
        result.places.push_back(x(world.position(body)) - 1.0 * metre);
        result.least = std::min<double>(result.least, result.places.back() / metre);
        world.step(1.0 / 240 * second);
    }
    return result;
}

/// The closed form for zeta below 1.
Quantity<unit::Length> swinging(Quantity<unit::Time> t, double ratio) {
    const double omega = 2 * M_PI, damped = omega * std::sqrt(1 - ratio * ratio), s = in(t, second);
    return 0.2 * std::exp(-ratio * omega * s) * (std::cos(damped * s) + ratio * omega / damped * std::sin(damped * s)) *
           metre;
}

/// Three runs, one above the other.
void draw(const std::array<const Run*, 3>& runs, const std::array<const char*, 3>& names) {
    workbook::Film film("3.1", "Let go at one place, with three dampings",
                        "Three masses on springs of one frequency are let go. The first swings to and fro, the second "
                        "returns at once and stops, the third creeps back and is last.",
                        {.middle = metres(0, 0, 0), .width = 1.1 * metre, .height = 0.66 * metre});
    film.still(7);
    for (std::size_t k = 0; k < 3; ++k) {
        const double height = 0.16 - 0.21 * double(k);
        film.scenery().note(metres(-0.53, height + 0.08, 0), names[k]);
        film.scenery().line(std::vector{metres(0, height - 0.06, 0), metres(0, height + 0.06, 0)}, // where they rest
                            workbook::paints::stone);
    }
    for (std::size_t n = 0; n < runs[0]->places.size(); n += 12) {
        auto& frame = film.frame(runs[0]->times[n]);
        for (std::size_t k = 0; k < 3; ++k) {
            const double height = 0.16 - 0.21 * double(k), place = in(runs[k]->places[n], metre);
            frame.line(std::vector{metres(-0.53, height, 0), metres(place, height, 0)}, workbook::paints::wire)
                .ball(metres(place, height, 0), 0.04 * metre, workbook::paints::ball);
        }
    }
    film.write();
}

} // namespace

int main() {
    workbook::Claims claim;
    const auto swings = run(0.1), half = run(0.5), critical = run(1), creeps = run(3);

    double off = 0;
    for (std::size_t i = 0; i < swings.times.size(); ++i)
        off = std::max<double>(off, std::abs((swings.places[i] - swinging(swings.times[i], 0.1)) / metre));
    std::cout << "zeta 0.1: off its closed form by " << off << " m at most\n";
    claim("below 1 it swings, as the closed form says", off < 1e-3 && swings.least < -0.1);

    std::cout << "zeta 0.5, which is c = sqrt(k m): it swings over by " << -half.least << " m\n";
    claim("sqrt(k m) is not the critical damping: the mass swings over", half.least < -0.02);
    claim("2 sqrt(k m) is: it returns and never swings over", critical.least >= 0);
    claim("above it, it creeps", creeps.least >= 0);
    std::cout << "After 1 s: critical " << critical.places[240] << ", zeta 3 " << creeps.places[240] << '\n';
    claim("more damping than critical is slower, not faster", creeps.places[240] > 5.0 * critical.places[240]);

    draw({&swings, &critical, &creeps}, {"zeta = 0.1", "zeta = 1, critical", "zeta = 3"});
    workbook::Plot plot("3.1", "Below the critical damping it swings, above it creeps");
    plot.x("time").y("displacement");
    plot.line("zeta 0.1", swings.times, swings.places)
        .line("zeta 1", critical.times, critical.places)
        .line("zeta 3", creeps.times, creeps.places);
    std::vector<Quantity<unit::Time>> seldom; // points, or the curve would hide them
    for (std::size_t i = 0; i < swings.times.size(); i += 24) seldom.push_back(swings.times[i]);
    plot.points("closed form", seldom, [](Quantity<unit::Time> t) { return swinging(t, 0.1); }).write();
    return claim.result();
}
