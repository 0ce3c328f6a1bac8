// SPDX-License-Identifier: BSL-1.0
// 2.1.2.3 A step that is too large: through the wall, or out of it on the wrong side

// Collisions are not detected, intersections are. "The time step must be small enough such that the contact point is on
// the correct side of both entities, otherwise the interface will be resolved in the opposite direction". A ball of
// radius r that moves more than 2 r + w in a step is never seen in a wall of thickness w; one that ends beyond the
// middle of the wall is pushed out behind it. Two answers besides a smaller step: a narrowphase that follows the motion
// through the step and keeps the ball where it first touches (Swept), and a response that finds in advance what may
// come to touch within the step (SoftSubsteps). (A part of 2.1.2.)

#include "claims.hpp"
#include "film.hpp"
#include "plot.hpp"
#include "say.hpp"

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <string>
#include <vector>

using namespace ansatz;

namespace {

constexpr double r = 0.1, w = 0.1; // m
constexpr auto dt = 1.0 / 60 * second;

//! [shot]
/// How far behind the middle of a wall a ball is half a second after it was shot at it, m.
template <class... Policy> double shot(double speed, double from, Policy... narrowphase_and_response) {
    World world{SemiImplicitEuler{}, BoundingBoxes{}, narrowphase_and_response...};
    world.add(Box{metres(w / 2, 5, 5)}, fixed);
    const auto ball = world.add(Sphere{r * metre}, position(metres(-from, 0, 0)),
                                velocity(metres_per_second(speed, 0, 0)), mass(1.0 * kilogram));
    for (int i = 0; i < 30; ++i) world.step(dt);
    return in(x(world.position(ball)), metre);
}
//! [shot]

/// Where a ball is after each step that is shot at the wall with 30 m/s, for the film.
template <class... Policy> std::vector<double> path_of_a_shot(Policy... narrowphase_and_response) {
    World world{SemiImplicitEuler{}, BoundingBoxes{}, narrowphase_and_response...};
    world.add(Box{metres(w / 2, 5, 5)}, fixed);
    const auto ball = world.add(Sphere{r * metre}, position(metres(-1.75, 0, 0)), velocity(metres_per_second(30, 0, 0)),
                                mass(1.0 * kilogram));
    std::vector<double> places;
    for (int n = 0; n <= 7; ++n, world.step(dt)) places.push_back(in(x(world.position(ball)), metre));
    return places;
}
/// The same shot three times, one above the other, twenty times slower; where each ball is in the end, m.
std::array<double, 3> side_by_side() {
    const Narrowphase<Sphere, Box> now;
    const std::array paths{path_of_a_shot(now, Impulse<>{}, Projection{}), path_of_a_shot(now, SoftSubsteps<>{}),
                           path_of_a_shot(Swept{now}, Impulse<>{}, Projection{})};
    const std::array names{"Impulse and Projection", "SoftSubsteps", "Swept"};
    workbook::Film film(
        "2.1.2.3", "Three shots at a wall, step by step",
        "Three balls are shot at a thin wall. The first is before the wall in one step and behind it in "
        "the next; those that detect it ahead stop where they touch it.",
        {.middle = metres(0, 0.1, 0), .width = 4.4 * metre, .height = 2.1 * metre});
    film.still(4);
    film.scenery().box(metres(0, 0, 0), metres(w / 2, 0.9, 0.01), workbook::paints::stone);
    for (std::size_t k = 0; k < 3; ++k) film.scenery().note(metres(-2.1, 0.85 - 0.6 * double(k), 0), names[k]);
    for (std::size_t n = 0; n < paths[0].size(); ++n)
        for (int held = 0; held < 5; ++held) {
            auto& frame = film.frame((double(n) + 0.2 * held) * 20.0 * dt);
            for (std::size_t k = 0; k < 3; ++k)
                frame.ball(metres(paths[k][n], 0.6 - 0.6 * double(k), 0), r * metre, workbook::paints::ball);
        }
    film.write();
    return {paths[0].back(), paths[1].back(), paths[2].back()};
}

} // namespace

int main() {
    workbook::Claims claim;
    const double critical = (2 * r + w) * 60;
    std::cout << "Critical speed (2 r + w) / dt = " << critical << " m/s\n";
    auto behind = [&](double speed, auto... policy) {
        int through = 0;
        for (int i = 0; i < 100; ++i)
            through += shot(speed, 1 + i * speed / 6000, policy...) > 0; // from a hundred places
        return through;
    };
    const Narrowphase<Sphere, Box> now;
    const Swept throughout{now};
    std::vector<double> speeds, plain, ahead, swept;
    for (double v = 2; v <= 60; v += 2) {
        speeds.push_back(v);
        plain.push_back(behind(v, now, Impulse<>{}, Projection{}));
        ahead.push_back(behind(v, now, SoftSubsteps<>{}));
        swept.push_back(behind(v, throughout, Impulse<>{}, Projection{}));
    }
    workbook::say() << "Of 100 balls at 8 m/s " << plain[3] << " come out behind the wall, at 30 m/s " << plain[14]
                    << "; with Swept " << swept[3] << " and " << swept[14] << '\n'
                    << "At 500 m/s: " << behind(500, now, Impulse<>{}, Projection{}) << ", with Swept "
                    << behind(500, throughout, Impulse<>{}, Projection{}) << "; it keeps a ball at " << std::fixed
                    << std::setprecision(3) << shot(500, 1, throughout, Impulse<>{}, Projection{})
                    << " m, where it touches\n";
    claim("while a step is shorter than half of the way through, all are stopped",
          plain[2] == 0 && shot(8.9, 1, now, Impulse<>{}, Projection{}) < 0);
    claim("beyond the middle a ball is resolved in the opposite direction, below the critical speed already",
          behind(16, now, Impulse<>{}, Projection{}) > 0);
    claim("above it some are never seen", plain.back() > 50);
    claim("a response that detects ahead stops all of them", ahead.back() == 0);
    claim("Swept stops all of them, at 500 m/s, too", *std::max_element(swept.begin(), swept.end()) == 0 &&
                                                          behind(500, throughout, Impulse<>{}, Projection{}) == 0);
    claim("and keeps a ball where it touches the wall",
          std::abs(shot(500, 1, throughout, Impulse<>{}, Projection{}) + r + w / 2) < 1e-12);

    const auto [never_seen, detected_ahead, followed] = side_by_side();
    std::cout << "The shot of the film at 30 m/s ends at " << never_seen << " m, " << detected_ahead << " m and "
              << followed << " m\n";
    claim("what detects ahead stops it where it touches",
          never_seen > 1 && std::abs(detected_ahead + r + w / 2) < 1e-3 && std::abs(followed + r + w / 2) < 1e-12);

    workbook::Plot plot("2.1.2.3", "Fast balls come out behind the wall");
    plot.x("speed (m/s)").y("balls of 100 behind the wall").vertical(critical, "(2r + w) / dt");
    plot.line("Impulse and Projection", speeds, plain)
        .line("SoftSubsteps", speeds, ahead)
        .line("Swept", speeds, swept)
        .write();
    return claim.result();
}
