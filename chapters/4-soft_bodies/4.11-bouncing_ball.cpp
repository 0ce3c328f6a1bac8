// SPDX-License-Identifier: BSL-1.0
// 4.11 A soft ball bounces: none of its bodies does, all of it does

// Every body of this ball has restitution 0: alone it would hit the ground and stay. The ball bounces because its
// springs take up what it falls with, and give it back. Not all of it: what they keep is the swinging of the ball
// in itself, which their damping turns into heat, so that each leap is lower than the one before. In the air none of
// this matters to its centre of mass, which falls as a single body does. (A part of section 4, which the notes do not
// divide.)

#include "claims.hpp"
#include "film.hpp"

#include <ansatz/collision.hpp>
#include <ansatz/soft_bodies/soft_ball.hpp>
#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <vector>

using namespace ansatz;
using Length = Quantity<unit::Length>;

int main() {
    workbook::Claims claim;
    //! [ball]
    World world{SemiImplicitEuler{},        Gravity{}, Springs{}, SortAndSweep{}, Narrowphase<Sphere, Plane>{},
                SoftSubsteps<>{.parts = 20}};
    world.add(Plane::ground(), fixed, restitution(0));
    const SoftBall ball{.centre = metres(0, 1.3, 0),
                        .radius = 0.3 * metre,
                        .density = 60.0 * kilogram_per_cubic_metre,
                        .structural = {600.0 * newton_per_metre, 0.3 * newton_second_per_metre},
                        .bend = {200.0 * newton_per_metre, 0.1 * newton_second_per_metre},
                        .spokes = {600.0 * newton_per_metre, 0.3 * newton_second_per_metre}};
    const SoftBallParts parts = add_soft_ball(world, ball, Sphere{0.01 * metre}, restitution(0));
    //! [ball]
    const TriangleMesh mesh = ball_mesh(ball.radius, ball.divisions, ball.centre);
    workbook::Film film("4.11", "A soft ball bounces, though none of its bodies does",
                        "A ball of springs falls, is pressed flat against the ground, and leaps, lower each time.",
                        {.middle = metres(0, 0.68, 0),
                         .width = 3.2 * metre,
                         .height = 1.9 * metre,
                         .turn = degrees(15),
                         .above = degrees(12)});
    film.still(9).scenery().ground(metres(-1.2, 0, -0.8), metres(1.2, 0, 0.8), 0.4 * metre);

    Quantity<unit::Mass> whole{};
    for (const Handle body : parts.bodies) whole += world.mass(body);
    const double first = total_energy(world).value();
    double most = first;
    auto flattest = 1.0 * metre, after = 0.0 * metre;
    std::vector<Length> tops; // of its centre of mass, leap by leap
    Length before{};
    bool rising = false, in_the_air = true, free_fall = true;
    for (int n = 0; n < 3 * 120; ++n) {
        std::vector<VectorQuantity<unit::Length>> skin;
        auto low = 10.0 * metre, high = -10.0 * metre;
        for (std::size_t v = 0; v < mesh.vertices().size(); ++v) {
            skin.push_back(world.position(parts.bodies[v]));
            low = std::min(low, y(skin.back()));
            high = std::max(high, y(skin.back()));
        }
        flattest = std::min<Length>(flattest, high - low);
        if (n % 5 == 0 && n <= 60 * 5)
            film.frame(world.time())
                .shadow(skin, 0.0 * metre)
                .mesh(skin, mesh.triangles(), workbook::paints::ball, true);
        const auto centre = centre_of_mass(world);
        if (rising && y(centre) < before) tops.push_back(before);
        rising = y(centre) > before && n > 0;
        before = y(centre);

        const auto v = total_momentum(world) / whole;
        world.step(1.0 / 120 * second);
        in_the_air = low > 0.1 * metre;
        const auto gained = y(total_momentum(world) / whole - v) + 9.81 / 120 * metre_per_second;
        free_fall = free_fall && (!in_the_air || abs(gained) < 1e-9 * metre_per_second);
        most = std::max(most, total_energy(world).value());
        after = y(centre);
    }
    std::cout << "It falls by 1 m onto its lowest point, and is pressed from 0.6 m to "
              << std::round(1e3 * flattest.value()) / 1e3 << " m\nIts centre leaps to";
    for (const Length& top : tops) std::cout << ' ' << std::round(1e3 * top.value()) / 1e3 << " m";
    std::cout << "\nIts energy was " << std::round(first * 100) / 100 << " J; the most of it afterwards is "
              << std::round((most - first) * 1e3) / 1e3 << " J more\n";
    claim("it is pressed flat by a tenth at least, and comes back", flattest < 0.54 * metre && after > 0.2 * metre);
    claim("it leaps, to more than a third of its fall", !tops.empty() && tops[0] > (0.3 + 1.0 / 3) * metre);
    claim("each leap is lower than the one before",
          tops.size() > 1 && std::is_sorted(tops.rbegin(), tops.rend()) && tops[0] < 1.2 * metre);
    claim("in the air its centre of mass falls as one body does", free_fall);
    claim("no energy comes from nothing: not a thousandth", most < first * 1.001);
    film.write();
    return claim.result();
}
