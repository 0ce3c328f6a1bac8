// SPDX-License-Identifier: BSL-1.0
// 4.3 Hung by two corners: a sheet falls, swings and hangs; the two corners carry all of it

// Two pins, gravity, and a sheet that begins level. Where it hangs in the end each spring pulls with what the cloth
// below and beside it weighs, and all of that arrives at two corners: there it is stretched most, and there it would
// tear. How long a step may be is asked beforehand, since a sheet whose step is too long explodes before it hangs. (A
// part of section 4, which the notes do not divide.)

#include "claims.hpp"
#include "film.hpp"
#include "plot.hpp"

#include <ansatz/soft_bodies.hpp>
#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <vector>

using namespace ansatz;

namespace {
/// Where every second body of every second row is.
template <class World_> auto every_second(const World_& world, const ClothParts& sheet, std::size_t n) {
    std::vector<VectorQuantity<unit::Length>> places;
    for (std::size_t j = 0; j < n; j += 2)
        for (std::size_t i = 0; i < n; i += 2) places.push_back(world.position(sheet.bodies[i + n * (n - 1 - j)]));
    return places;
}
} // namespace

int main() {
    workbook::Claims claim;
    const std::size_t n = 17;

    //! [hang]
    World world{SemiImplicitEuler{}, Gravity{}, Springs{}, Drag{1.0 / second}};
    const ClothParts sheet =
        add_cloth(world, {.mesh = TriangleMesh::grid(n, n, metres(1, 0, 0), metres(0, 0, 1)), // level
                          .mass_per_area = 0.2 * kilogram / square_metre,
                          .structural = {30.0 * newton_per_metre, 0.02 * newton_second_per_metre},
                          .shear = {10.0 * newton_per_metre, 0.02 * newton_second_per_metre},
                          .bend = {1.0 * newton_per_metre, 0.01 * newton_second_per_metre},
                          .pins = {0, n - 1}}); // two corners of one side
    const auto stable = stable_step(world);
    //! [hang]
    const auto dt = 0.8 * stable;
    std::cout << "The largest stable step is at least " << stable << '\n';
    const auto pins = std::array{world.position(sheet.bodies[0]), world.position(sheet.bodies[n - 1])};

    workbook::Film film(
        "4.3", "A level sheet is let go, and hangs from two corners",
        "A square of cloth lies level, falls at its free side, swings through under its two pins, and comes "
        "to hang with folds that run to the pins.",
        {.middle = metres(0.5, -0.5, 0.1),
         .width = 2.3 * metre,
         .height = 1.6 * metre,
         .turn = degrees(-30),
         .above = degrees(18)});
    const auto apart = std::uint64_t(std::round(0.05 / dt.value())); // steps between two frames
    std::vector<Quantity<unit::Time>> times;
    std::vector<Quantity<unit::Length>> heights;
    while (world.time() < 20.0 * second) {
        if (world.time() < 8.0 * second && world.tick() % 8 == 0) {
            times.push_back(world.time());
            heights.push_back(y(world.position(sheet.bodies[n * n - 1])));
        }
        if (world.tick() % apart == 0 && film.frames() < 64)
            film.frame(world.time()).sheet(every_second(world, sheet, n), 9, workbook::paints::cloth);
        world.step(dt);
    }
    film.still(8).write();
    claim("the pins are where they were, bit for bit",
          world.position(sheet.bodies[0]) == pins[0] && world.position(sheet.bodies[n - 1]) == pins[1]);

    // What the springs at the pins pull with.
    //! [pull]
    Quantity<unit::Force> carried{}, largest{}, at_pins{};
    for (const SpringHandle spring : world.elements<Spring>().handles()) {
        const Spring it = world.get(spring);
        const auto along = world.position(it.second.body()) - world.position(it.first.body());
        const Quantity<unit::Force> tension = it.stiffness * (norm(along) - *it.rest_length);
        largest = std::max(largest, abs(tension));
        for (const auto& [end, sign] : {std::pair{it.first, -1.0}, {it.second, 1.0}}) // what pulls the pin downwards
            if (world.motion(end.body()) == Motion::fixed) {
                carried += sign * tension * (y(along) / norm(along));
                at_pins = std::max(at_pins, abs(tension));
            }
    }
    //! [pull]
    Quantity<unit::Force> weight{};
    Quantity<unit::Velocity> fastest{};
    for (const Handle body : sheet.bodies)
        if (world.motion(body) == Motion::awake) {
            weight += world.mass(body) * (9.81 * metre_per_second_squared);
            fastest = std::max(fastest, norm(world.velocity(body)));
        }
    std::cout << "The pins carry " << carried << "; what hangs weighs " << weight << '\n'
              << "The largest tension is " << largest << ", and at the pins it is " << at_pins << '\n';
    claim("it hangs still", fastest < 1e-3 * metre_per_second);
    claim("two corners carry all of it", abs(carried - weight) < 1e-3 * weight);
    claim("the cloth is stretched most at the pins", at_pins == largest);
    bool same = true;
    for (std::size_t j = 0; j < n; ++j)
        for (std::size_t i = 0; i < n; ++i) {
            const auto a = world.position(sheet.bodies[i + n * j]), b = world.position(sheet.bodies[n - 1 - i + n * j]);
            same = same && abs(x(a) + x(b) - 1.0 * metre) < 1e-3 * metre && abs(y(a) - y(b)) < 1e-3 * metre;
        }
    claim("its left half hangs as its right half does", same);

    workbook::Plot fall("4.3-fall", "A level sheet is let go: the height of its free corner");
    fall.x("time").y("height").line("free corner", times, heights).write();
    // Each second thread, to and fro, so that all of one direction are one line.
    std::vector<Quantity<unit::Length>> across_x, across_y, along_x, along_y;
    for (std::size_t line = 0; line < n; line += 2)
        for (std::size_t i = 0; i < n; ++i) {
            const std::size_t to = line % 4 == 0 ? i : n - 1 - i;
            across_x.push_back(x(world.position(sheet.bodies[to + n * line])));
            across_y.push_back(y(world.position(sheet.bodies[to + n * line])));
            along_x.push_back(x(world.position(sheet.bodies[line + n * to])));
            along_y.push_back(y(world.position(sheet.bodies[line + n * to])));
        }
    workbook::Plot plot("4.3", "A sheet hung by two corners, from the front: each second thread");
    plot.x("across").y("height").equal_axes();
    plot.line("across", across_x, across_y).line("along", along_x, along_y).write();
    return claim.result();
}
