// SPDX-License-Identifier: BSL-1.0
// 7.4.1 A stone that sinks: it hangs on the surface by a spring, breaks it, and frees the column of water

// "... attaching a spring between the entity being submerged and the surface of the fluid. Once the entity sinks far
// enough into the fluid body it breaks the spring and frees the column of water." What hangs on the spring is carried
// by the water, so the water is pressed by it: the weight over rho g is displaced, and rises around it. When the spring
// breaks, that water is free, falls back, and a wave runs. A duck on the same spring stays. (A part of 7.4.)

#include "claims.hpp"
#include "film.hpp"
#include "plot.hpp"
#include "say.hpp"

#include <ansatz/water.hpp>
#include <ansatz/world.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <vector>

using namespace ansatz;
using Length = Quantity<unit::Length>;

int main() {
    workbook::Claims claim;
    //! [spring]
    World world{SemiImplicitEuler{}, Gravity{}, Pools<Pipes>{}, Buoyancy{}};
    const Pipes water{.damping = 0.2 / second};
    const auto pond = world.add(Pool{Surface{water, ColumnGrid(48, 48, 0.25 * metre), 2.0 * metre}});
    const SurfaceSpring spring{
        .stiffness = 400.0 * newton_per_metre, .damping = 40.0 * newton_second_per_metre, .breaks_at = 0.6 * metre};
    const auto stone = world.add(position(metres(4, 2, 6)), mass(30.0 * kilogram));
    const auto duck = world.add(position(metres(8, 2, 6)), mass(8.0 * kilogram));
    const auto on_stone = world.add(Floating{stone, spring}), on_duck = world.add(Floating{duck, spring});
    //! [spring]
    const auto before = world.water(pond).volume();
    std::vector<Quantity<unit::Time>> times;
    std::vector<Length> stone_at, duck_at, level;
    double broke = 0, most = 0, after = 0;
    workbook::Film film(
        "7.4.1", "A stone hangs on the surface until its spring breaks",
        "A stone and a duck are let go at the surface of a pond, each on a spring. The stone goes deeper, its spring "
        "breaks, it sinks, and the water above it closes with a wave. The duck stays.",
        {.middle = metres(6, 1.25, 6), .width = 7.0 * metre, .height = 3.0 * metre});
    film.may_change().still(24).rate(30).scenery().box(metres(6, -0.1, 6), metres(3.5, 0.1, 0.1),
                                                       workbook::paints::stone);
    for (int n = 0; n < 360; ++n) {
        if (n % 4 == 0 && n < 200) {
            auto& frame = film.frame(world.time());
            const auto draw = [&](Handle body, auto held_by, double radius, const workbook::Paint& paint) {
                const auto here = world.position(body),
                           above = metres(x(here).value(), world.afloat(held_by).level.value(), 6);
                if (!world.afloat(held_by).broken) frame.line(std::vector{above, here}, workbook::paints::wire);
                frame.ball(metres(x(here).value(), std::max(radius, y(here).value()), 6.01), radius * metre, paint);
            };
            draw(stone, on_stone, 0.2, workbook::paints::stone);
            draw(duck, on_duck, 0.15, workbook::paints::ball);
            std::vector<VectorQuantity<unit::Length>> surface;
            for (int i = 0; i <= 70; ++i) {
                const auto along = (2.5 + 0.1 * i) * metre;
                surface.push_back(metres(along.value(), world.water(pond).level(along, 6.0 * metre).value(), 7));
            }
            frame.filled(surface, 0.0 * metre, workbook::paints::water);
        }
        const bool held = !world.afloat(on_stone).broken;
        world.step(1.0 / 120 * second);
        most = std::max(most, world.water(pond).displaced().value());
        if (held && world.afloat(on_stone).broken) {
            broke = (n + 1) / 120.0;
            after = world.water(pond).displaced().value();
        }
        times.push_back(double(n + 1) / 120 * second);
        stone_at.push_back(std::max(0.0 * metre, y(world.position(stone))));
        duck_at.push_back(y(world.position(duck)));
        level.push_back(world.water(pond).level(4.0 * metre, 7.0 * metre));
    }
    std::cout << "The stone broke its spring after " << std::round(broke * 100) / 100 << " s\n";
    claim("the stone sinks far enough and breaks its spring", world.afloat(on_stone).broken);
    workbook::say() << "Up to " << std::round(most * 1e4) / 10 << " litres were pressed up; when the spring broke, "
                    << std::round(after * 1e4) / 10 << " were left, which the duck presses\n";
    claim("the column is free", after < 0.5 * most);
    std::cout << "The duck hangs " << std::round((world.afloat(on_duck).level - y(world.position(duck))).value() * 100)
              << " cm under the surface\n";
    claim("the duck stays", !world.afloat(on_duck).broken);
    claim("nothing carries the stone any more", y(world.acceleration(stone)) == -9.81 * metre_per_second_squared);
    claim("no water is lost", std::abs(double(world.water(pond).volume() / before) - 1) < 1e-12);

    film.write();
    workbook::Plot plot("7.4.1", "A stone hangs on the surface until its spring breaks; the duck is lighter");
    plot.x("time").y("height").y_range(0.0 * metre, 2.2 * metre);
    plot.line("stone", times, stone_at)
        .line("duck", times, duck_at)
        .line("water, a metre from the stone", times, level);
    plot.write();
    return claim.result();
}
