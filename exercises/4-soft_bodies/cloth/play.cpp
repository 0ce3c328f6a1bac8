// SPDX-License-Identifier: BSL-1.0
// The scene of section 4 with your sheet in it: a flag that is held at two corners and swings for a second.

#include "play.hpp"
#include "plot.hpp"
#include "subject.hpp"

#include <ansatz/soft_bodies.hpp>
#include <ansatz/springs.hpp>

using namespace ansatz;

const exercise::Sheet sheet{12, 8, 1.2 * metre, 0.7 * metre};
const auto mass_per_area = 0.2 * kilogram / square_metre;
const SpringConstants threads{200.0 * newton_per_metre, 0.02 * newton_second_per_metre},
    shear{100.0 * newton_per_metre, 0.02 * newton_second_per_metre}, bend{5.0 * newton_per_metre};
const auto dt = 1e-3 * second;

auto empty_world() { return World{SemiImplicitEuler{}, Gravity{}, Springs{}}; }
auto yours() {
    auto world = empty_world();
    std::vector<Handle> bodies;
    for (int v = 0; v < sheet.columns * sheet.rows; ++v) {
        const int i = v % sheet.columns, j = v / sheet.columns;
        const auto at = position(metres(1.2 * i / (sheet.columns - 1), 0, 0.7 * j / (sheet.rows - 1)));
        bodies.push_back(v == 0 || v == sheet.columns - 1
                             ? world.add(at, fixed)
                             : world.add(at, mass(exercise::mass(sheet, v, mass_per_area))));
    }
    auto add = [&](const exercise::Springs& springs, const SpringConstants& constants) {
        for (const auto& [a, b] : springs)
            world.add(Spring{.first = bodies[std::size_t(a)],
                             .second = bodies[std::size_t(b)],
                             .stiffness = constants.stiffness,
                             .damping = constants.damping,
                             .rest_length = exercise::rest_length(sheet, a, b)});
    };
    add(exercise::along(sheet, 1), threads);
    add(exercise::diagonals(sheet), shear);
    add(exercise::along(sheet, 2), bend);
    return std::pair(world, bodies);
}
auto library() {
    auto world = empty_world();
    const auto cloth = add_cloth(world, {.mesh = TriangleMesh::grid(12, 8, metres(1.2, 0, 0), metres(0, 0, 0.7)),
                                         .mass_per_area = mass_per_area,
                                         .structural = threads,
                                         .shear = shear,
                                         .bend = bend,
                                         .pins = {0, 11}});
    return std::pair(world, cloth.bodies);
}

int main() {
    workbook::Play table("A flag of 12 x 8 bodies is held at two corners, falls and swings for a second.",
                         {"springs", "mass, kg", "lowest corner, m"});
    workbook::Plot plot("play-soft_bodies.cloth", "A flag that falls: yours and the library's");
    plot.x("time", "s").y("height of a free corner", "m");
    auto show = [&](const char* who, auto made) {
        auto& [world, bodies] = made;
        double sum = 0;
        for (const Handle& body : bodies)
            if (world.motion(body) == Motion::awake) sum += world.mass(body).value();
        std::vector<double> times, heights;
        for (int n = 0; n < 1000; ++n) {
            world.step(dt);
            times.push_back((n + 1) * dt.value());
            heights.push_back(y(world.position(bodies.back())).value());
        }
        plot.line(who, times, heights);
        table.row(who, {double(world.template elements<Spring>().size()), sum, heights.back()}, 96,
                  [world = world]() mutable { world.step(dt); });
    };
    show("yours", yours());
    show("library", library());
    plot.write();
    return table.print();
}
