// SPDX-License-Identifier: BSL-1.0
// 7.4.3 A soft surface: one thing sinks, one floats, one bounces, and their contacts are counted

// "If representing the surface of a fluid body as a soft body then additional engineering challenges need to be
// addressed in the handling of multiple sustained collisions when objects either sink, float on or bounce off the
// surface of the fluid." The surface is a net of bodies and springs, of chapters 3 and 4. A body meets the mean of what
// is under it: one contact, however many columns carry it, with the notes' spring that is slack above the surface. With
// damping a body comes to float, without it is thrown back, and one too heavy for the spring sinks, and the surface
// closes. (A part of 7.4.)

#include "claims.hpp"
#include "film.hpp"
#include "plot.hpp"
#include "say.hpp"

#include <ansatz/water.hpp>
#include <ansatz/world.hpp>

#include <array>
#include <cmath>
#include <iostream>
#include <numbers>
#include <string>
#include <vector>

using namespace ansatz;
using Length = Quantity<unit::Length>;

int main() {
    workbook::Claims claim;
    //! [surface]
    World world{VelocityVerlet{}, Gravity{}, Springs{}, SurfaceContacts{}};
    const auto pond = add_soft_surface(world, {.grid = ColumnGrid(24, 24, 0.25 * metre),
                                               .mass_per_area = 50.0 * kilogram / square_metre,
                                               .tension = 2000.0 * newton_per_metre,
                                               .damping = 10.0 / second});
    //! [surface]
    // A bed: bodies that nothing moves, and a spring that is far stiffer.
    SoftSurfaceParts bed{ColumnGrid(3, 3, 2.0 * metre), {}, {}, {}};
    for (int n = 0; n < 9; ++n)
        bed.bodies.push_back(world.add(position(metres(2 * (n % 3) + 1, -2, 2 * (n / 3) + 1)), fixed));
    const SurfaceSpring ground{20000.0 * newton_per_metre, 3000.0 * newton_second_per_metre, 1.0 * metre};

    //! [things]
    struct Thing {
        std::string name;
        Handle body;
        SurfaceContactHandle on;
        std::vector<Length> heights = {};
        std::vector<double> begins = {};
    };
    std::vector<Thing> things;
    auto put = [&](const char* name, double x, double y, Quantity<unit::Mass> kilograms, const SurfaceSpring& spring) {
        const auto body = world.add(position(metres(x, y, x)), mass(kilograms));
        things.push_back({name, body, world.add(SurfaceContact::of(pond, body, spring, 0.3 * metre))});
        world.add(SurfaceContact::of(bed, body, ground, 0.3 * metre));
    };
    const auto none = 0.0 * newton_second_per_metre, some = 60.0 * newton_second_per_metre;
    put("stone", 1.5, 0.6, 60.0 * kilogram, {800.0 * newton_per_metre, some, 0.6 * metre});
    put("raft", 4.5, 0.35, 20.0 * kilogram, {700.0 * newton_per_metre, some, 0.6 * metre});
    put("ball", 3.0, 1.2, 10.0 * kilogram, {300.0 * newton_per_metre, none, 3.0 * metre});
    //! [things]

    constexpr int rate = 120;
    std::vector<Quantity<unit::Time>> times;
    const double first = total_energy(world).value();
    double least = first, rise = 0, closest = 60;
    workbook::Film film(
        "7.4.3", "One sinks, one floats, one bounces",
        "A net of water with three balls. The one at the back pushes it down, falls through, and the surface closes; "
        "the one in front comes to float; the one in the middle leaps again and again.",
        {.middle = metres(3, 0.1, 3), .width = 6.6 * metre, .height = 4.3 * metre, .above = degrees(22)});
    film.rate(15).may_leave().still(12);
    for (int n = 1; n <= 60 * rate; ++n) {
        if (n % 8 == 1 && film.frames() < 75) {
            std::vector<VectorQuantity<unit::Length>> surface;
            for (std::size_t k = 0; k < 24 * 24; ++k)
                if (k / 24 % 2 == 0) surface.push_back(world.position(pond.bodies[k]));
            auto& frame = film.frame(world.time());
            frame.rows(surface, 24, -0.6 * metre, workbook::paints::sea);
            const std::array colours{workbook::paints::stone, workbook::paints::wood, workbook::paints::ball};
            for (std::size_t k = 0; k < 3; ++k) frame.ball(world.position(things[k].body), 0.3 * metre, colours[k]);
        }
        std::vector<std::uint64_t> before;
        for (const auto& thing : things) before.push_back(surface_touch(world, thing.on).begun);
        world.step(1.0 / rate * second);
        const double energy = total_energy(world).value();
        rise = std::max(rise, energy - least);
        least = std::min(least, energy);
        if (n <= 8 * rate) times.push_back(double(n) / rate * second);
        for (std::size_t k = 0; k < 3; ++k) {
            auto& thing = things[k];
            if (n <= 8 * rate) thing.heights.push_back(y(world.position(thing.body)));
            if (surface_touch(world, thing.on).begun == before[k]) continue;
            if (!thing.begins.empty()) closest = std::min(closest, double(n) / rate - thing.begins.back());
            thing.begins.push_back(double(n) / rate);
        }
    }
    for (const auto& thing : things) {
        const auto now = surface_touch(world, thing.on);
        workbook::say() << "The " << thing.name << ": contacts begun in a minute: " << thing.begins.size()
                        << (now.broken ? "; it broke its spring, and lies on the bed\n" : "\n");
    }
    const auto stone = surface_touch(world, things[0].on), raft = surface_touch(world, things[1].on);
    claim("one sinks", stone.broken && y(world.position(things[0].body)) < -1.5 * metre);
    claim("one floats, in a contact that never ends", raft.touches && raft.begun == 1);
    claim("one bounces, for all of the minute", things[2].begins.size() > 30);
    const double bobs = 2 * std::numbers::pi * std::sqrt(10.0 / 300);
    std::cout << "Two contacts of the ball begin " << std::round(closest * 100) / 100
              << " s apart or more; it would bob in " << std::round(bobs * 100) / 100 << " s\n";
    claim("no contact begins twice in a second, nor in the time in which the ball would bob",
          closest > 1 && closest > bobs);
    // What the scheme adds on the way into a spring, it takes on the way out: it is of second order.
    claim("no energy comes from nothing: what the scheme adds is not a ten thousandth of what is lost",
          rise < 1e-4 * (first - least));
    std::cout << "Under the raft the surface has " << std::round(-raft.level.value() * 1000) / 10
              << " cm less, where all was level\n";
    claim("where the stone went down the surface is level again",
          std::abs(y(world.position(pond.bodies[24 * 2 + 2])).value()) < 2e-3);

    film.write();
    workbook::Plot plot("7.4.3", "One sinks, one floats, one bounces; the surface is at 0");
    plot.x("time").y("height of the middle");
    for (const auto& thing : things) plot.line(thing.name, times, thing.heights);
    plot.write();
    return claim.result();
}
