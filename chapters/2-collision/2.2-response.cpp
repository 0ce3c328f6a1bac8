// SPDX-License-Identifier: BSL-1.0
// 2.2 Response: places, velocities, accelerations

// Projection moves bodies apart and touches nothing else; impulse changes their velocities; penalty pushes with a
// force. They act at three levels, so that they can be combined: an impulse ends the approach, a projection the
// intersection. What a projection must share is the distance, by inverse mass, or the centre of mass moves with every
// contact.

#include "claims.hpp"
#include "plot.hpp"
#include "strokes.hpp"

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

#include <cmath>
#include <cstdint>
#include <iostream>
#include <map>
#include <string>
#include <vector>

using namespace ansatz;

namespace {

struct Fall {
    std::vector<Quantity<unit::Time>> times;
    std::vector<Quantity<unit::Length>> heights;
    double last_speed = 0; ///< m/s
};
//! [drop]
/// A ball that is dropped from 1 m onto the ground.
template <class... Response> Fall drop(Response... response) {
    World world{SemiImplicitEuler{}, Gravity{}, BoundingBoxes{}, Narrowphase<Sphere, Plane>{}, response...};
    world.add(Plane::ground(), fixed);
    const auto ball = world.add(Sphere{0.1 * metre}, position(metres(0, 1, 0)), mass(1.0 * kilogram));
    //! [drop]
    Fall fall;
    while (world.time() < 1.0 * second) {
        world.step(1.0 / 240 * second);
        fall.times.push_back(world.time());
        fall.heights.push_back(y(world.position(ball)));
    }
    fall.last_speed = in(y(world.velocity(ball)), metre_per_second);
    return fall;
}

/// Two heaps and a ball in the air: which bodies touch, and which hang together by that.
/// \return the number of islands
std::size_t draw_islands() {
    //! [islands]
    std::vector<scenes::Point> centres{{6.2, 2.6}}; // in the air
    for (int row = 0; row < 4; ++row)
        for (int i = 0; i < 4 - row; ++i) centres.emplace_back(1 + i + 0.5 * row, 0.49 + 0.86 * row);
    for (int row = 0; row < 3; ++row)
        for (int i = 0; i < 2; ++i) centres.emplace_back(7.5 + i + 0.1 * row, 0.49 + 0.98 * row);
    const Sphere ball{0.505 * metre};
    Islands islands;
    islands.reset(centres.size());
    scenes::Strokes links;
    for (std::uint32_t i = 0; i < centres.size(); ++i)
        for (std::uint32_t j = i + 1; j < centres.size(); ++j)
            if (contact(ball, metres(centres[i][0], centres[i][1]), ball, metres(centres[j][0], centres[j][1]))) {
                islands.unite(i, j);
                links.line(centres[i], centres[j]);
            }
    //! [islands]
    std::map<std::uint32_t, scenes::Strokes> balls;
    for (std::uint32_t i = 0; i < centres.size(); ++i) balls[islands.of(i)].circle(centres[i], 0.49);
    workbook::Plot plot("2.2-islands",
                        "Contacts make a graph, and its components are the islands; the ground joins none");
    plot.x("x", "m").y("y", "m").equal_axes();
    int number = 0;
    for (const auto& [root, strokes] : balls) strokes.draw(plot, "island " + std::to_string(++number));
    links.draw(plot, "contacts");
    scenes::Strokes().line({0, 0}, {10, 0}).draw(plot, "ground");
    plot.write();
    return balls.size();
}

} // namespace

int main() {
    workbook::Claims claim;
    const auto projected = drop(Projection{}), stopped = drop(Impulse<>{}),
               both = drop(Impulse<>{}, Projection{0.001 * metre});
    const auto pushed = drop(Penalty{5000.0 * newton_per_metre, 60.0 * newton_second_per_metre});
    std::cout << "After 1 s: Projection " << projected.heights.back() << " at " << projected.last_speed
              << " m/s, Impulse " << stopped.heights.back() << ",\n"
              << "both " << both.heights.back() << " at " << both.last_speed << " m/s, Penalty "
              << pushed.heights.back() << '\n';
    claim("a projection alone holds the place and lets the velocity grow",
          projected.heights.back() > 0.09 * metre && projected.last_speed < -9);
    claim("an impulse alone ends the velocity and lets the ball sink", stopped.heights.back() < 0.09 * metre);
    claim("together they hold both", both.heights.back() > 0.098 * metre && std::abs(both.last_speed) < 0.05);
    claim("a penalty lets it lie mg/k deep", std::abs(in(pushed.heights.back(), metre) - (0.1 - 9.81 / 5000)) < 1e-3);

    //! [shared]
    World pair{SemiImplicitEuler{}, BoundingBoxes{}, Narrowphase<Sphere>{}, Projection{}};
    const auto light = pair.add(Sphere{0.5 * metre}, position(metres(0, 0, 0)), mass(1.0 * kilogram));
    const auto heavy = pair.add(Sphere{0.5 * metre}, position(metres(0.9, 0, 0)), mass(9.0 * kilogram));
    pair.step(1e-9 * second);
    const auto centre = (x(pair.position(light)) + 9.0 * x(pair.position(heavy))) / 10.0;
    //! [shared]
    std::cout << "Two that overlap by 0.1 m, of 1 kg and 9 kg, are moved by " << x(pair.position(light)) << " and "
              << x(pair.position(heavy)) - 0.9 * metre << '\n';
    claim("shared by inverse mass, the centre of mass stays", std::abs(in(centre, metre) - 0.81) < 1e-15);
    //! [halves]
    const double half_and_half = (1 * (0 - 0.05) + 9 * (0.9 + 0.05)) / 10; // m: each is moved by half of the depth
    //! [halves]
    std::cout << "Half and half, their centre of mass goes from " << 0.81 << " m to " << half_and_half << " m\n";
    claim("half and half, it moves by 4 cm", std::abs(half_and_half - 0.81 - 0.04) < 1e-12);

    claim("two heaps on one ground are two islands, and a ball in the air is one", draw_islands() == 3);
    workbook::Plot plot("2.2", "What each response makes of a ball that is dropped");
    plot.x("time").y("height of the centre");
    plot.line("Projection", projected.times, projected.heights).line("Impulse", stopped.times, stopped.heights);
    plot.line("Impulse and Projection", both.times, both.heights).line("Penalty", pushed.times, pushed.heights).write();
    return claim.result();
}
