// SPDX-License-Identifier: BSL-1.0
// 7.4.2 A box that floats: its draft, its period, and the water that it presses up

// The force is rho g V, with the volume V that is under water, which of a sphere and of an upright box is known
// exactly. So a box lies as deep as its density says, and bobs with 2 pi sqrt(d / g). What it displaces has to go
// somewhere: it rises in the columns around the box, and there its level is read. Put under the box, and read there,
// the water would carry the box that presses it up, and the box would climb. (A part of 7.4.)

#include "claims.hpp"
#include "film.hpp"
#include "plot.hpp"

#include <ansatz/water.hpp>
#include <ansatz/world.hpp>

#include <cmath>
#include <iostream>
#include <numbers>
#include <vector>

using namespace ansatz;
using Length = Quantity<unit::Length>;

namespace {
/// A frame: the pool cut through its middle, and the box.
template <class World_, class PoolHandle_, class Place>
void show(workbook::Film& film, const World_& world, PoolHandle_ pool, const Place& box) {
    std::vector<VectorQuantity<unit::Length>> surface;
    for (int i = 0; i <= 80; ++i) {
        const auto along = (1 + 0.1 * i) * metre;
        surface.push_back(metres(along.value(), world.water(pool).level(along, 5.0 * metre).value(), 6));
    }
    film.frame(double(film.frames()) * 0.05 * second)
        .box(box, metres(0.5, 0.5, 0.5), workbook::paints::wood)
        .filled(surface, 0.0 * metre, workbook::paints::water);
}
} // namespace

int main() {
    workbook::Claims claim;
    constexpr double rate = 120;
    //! [box]
    World world{SemiImplicitEuler{}, Gravity{}, Pools<WaterColumns>{}, Buoyancy{}};
    const WaterColumns water{.wave_speed = 3.0 * metre_per_second, .damping = 0.5 / second};
    const auto pool = world.add(Pool{Surface{water, ColumnGrid(40, 40, 0.25 * metre), 2.0 * metre}}); // 100 m^2
    const auto box = world.add(position(metres(5, 2.3, 5)), mass(600.0 * kilogram));
    const auto floating = world.add(Floating{.body = box, .by = Box{metres(0.5, 0.5, 0.5)}, .damping = 1.0 / second});
    for (int n = 0; n < 60 * int(rate); ++n) world.step(1 / rate * second);
    const auto now = world.afloat(floating);
    //! [box]
    const double draft = (now.level - y(world.position(box))).value() + 0.5;
    std::cout << "A box of 1 m and 600 kg draws " << std::round(draft * 1e5) / 1e5 << " m, and has raised the pool by "
              << std::round((now.level.value() - 2) * 1e5) / 100 << " mm\n";
    claim("its draft is its density over that of water", std::abs(draft - 0.6) < 1e-4);
    claim("the level rises by m / (rho A)", std::abs(now.level.value() - 2.006) < 6e-6);
    claim("no water is lost", std::abs(world.water(pool).volume().value() - 200) < 1e-10);

    // For the film it is lifted and let go again.
    workbook::Film film(
        "7.4.2", "A box of wood drops into a pool, and comes to float",
        "A box drops into a pool, goes under to its upper side, rises and bobs, less and less; waves run "
        "away from it. In the end six tenths of it are under water.",
        {.middle = metres(5, 1.5, 5), .width = 8.0 * metre, .height = 3.4 * metre});
    film.still(3).scenery().box(metres(5, -0.1, 5), metres(4, 0.1, 0.1), workbook::paints::stone);
    world.set_position(box, metres(5, 2.35, 5));
    world.set_velocity(box, metres_per_second(0, 0, 0));
    for (int n = 0; n < 6 * 80; ++n) {
        if (n % 6 == 0) show(film, world, pool, world.position(box));
        world.step(1 / rate * second);
    }
    film.write();

    // The same box alone, pushed down by 5 cm: nothing slows it, and it presses nothing up.
    //! [bob]
    World still{SemiImplicitEuler{}, Gravity{}, Pools<WaterColumns>{}, Buoyancy{}};
    still.add(Pool{Surface{water, ColumnGrid(40, 40, 0.25 * metre), 2.0 * metre}});
    const auto bobs = still.add(position(metres(5, 1.85, 5)), mass(600.0 * kilogram));
    still.add(Floating{.body = bobs, .by = Box{metres(0.5, 0.5, 0.5)}, .presses = false});
    //! [bob]
    std::vector<Quantity<unit::Time>> times;
    std::vector<Length> heights;
    std::vector<double> crossings;
    double before = -0.05;
    for (int n = 1; n < 40 * int(rate); ++n) {
        still.step(1 / rate * second);
        const double height = y(still.position(bobs)).value() - 1.9;
        if (before < 0 && height >= 0) crossings.push_back((n - 1 + before / (before - height)) / rate);
        before = height;
        if (n > 8 * int(rate)) continue;
        times.push_back(n / rate * second);
        heights.push_back((height + 1.9) * metre);
    }
    const double period = (crossings.back() - crossings.front()) / double(crossings.size() - 1);
    const double exact = 2 * std::numbers::pi * std::sqrt(0.6 / 9.81);
    std::cout << "It bobs once in " << std::round(period * 1e5) / 1e5 << " s; 2 pi sqrt(d / g) is "
              << std::round(exact * 1e5) / 1e5 << " s\n";
    const double omega_h = 2 * std::numbers::pi / exact / rate;
    claim("the difference is semi-implicit Euler's (omega h)^2 / 24",
          std::abs(period / exact - 1 + omega_h * omega_h / 24) < 2e-6);
    claim("it bobs as high as at first", heights.back().value() < 1.96);

    workbook::Plot plot("7.4.2", "A box of 600 kg, pushed down by 5 cm");
    plot.x("time").y("height of its middle");
    plot.line("box", times, heights)
        .reference("closed form", times,
                   [&](Quantity<unit::Time> t) {
                       return (1.9 - 0.05 * std::cos(2 * std::numbers::pi / exact * t.value())) * metre;
                   })
        .write();
    return claim.result();
}
