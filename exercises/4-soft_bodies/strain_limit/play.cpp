// SPDX-License-Identifier: BSL-1.0
// The scene of section 4.8 with your limit in it: a sheet falls into its two pins, and its springs may be longer by a
// tenth.

#include "play.hpp"
#include "plot.hpp"
#include "subject.hpp"

#include <ansatz/soft_bodies/cloth.hpp>
#include <ansatz/soft_bodies/strain_limit.hpp>
#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

using namespace ansatz;

const std::size_t n = 12;
const auto dt = 1.0 / 500 * second;
const int steps = 400;
const double most = 0.1;

template <class World_> ClothParts hang(World_& world) {
    return add_cloth(world, {.mesh = TriangleMesh::grid(n, n, metres(1, 0, 0), metres(0, -1, 0)),
                             .mass_per_area = 0.3 * kilogram / square_metre,
                             .structural = {20.0 * newton_per_metre, 0.02 * newton_second_per_metre},
                             .shear = {20.0 * newton_per_metre, 0.02 * newton_second_per_metre},
                             .pins = {0, n - 1}});
}

/// A world of springs alone, and your limit behind each of its steps.
struct Yours {
    World<SemiImplicitEuler, Gravity, Springs<>, Drag> world{SemiImplicitEuler{}, Gravity{}, Springs{},
                                                             Drag{2.0 / second}};
    ClothParts cloth = hang(world);
    exercise::Sheet sheet;
    int passes;
    explicit Yours(int most_passes) : passes(most_passes) {
        for (const auto body : cloth.bodies)
            sheet.ends.push_back({world.position(body), world.velocity(body), world.inverse_mass(body)});
        world.elements<Spring>().for_each([&](std::uint32_t, const auto& link) {
            sheet.threads.push_back({link.a, link.b, link.rest_length * metre});
        });
    }
    void step() {
        world.step(dt);
        for (std::size_t i = 0; i < sheet.ends.size(); ++i) {
            sheet.ends[i].position = world.position(cloth.bodies[i]);
            sheet.ends[i].velocity = world.velocity(cloth.bodies[i]);
        }
        exercise::limit(sheet, most, passes);
        for (std::size_t i = 0; i < sheet.ends.size(); ++i) {
            if (sheet.ends[i].inverse_mass == 0.0 / kilogram) continue;
            world.set_position(cloth.bodies[i], sheet.ends[i].position);
            world.set_velocity(cloth.bodies[i], sheet.ends[i].velocity);
        }
    }
};
struct Library {
    World<SemiImplicitEuler, Gravity, Springs<>, Drag, StrainLimit<>> world;
    explicit Library(int passes)
        : world{SemiImplicitEuler{}, Gravity{}, Springs{}, Drag{2.0 / second},
                StrainLimit{.most = most, .passes = passes}} {
        hang(world);
    }
    void step() { world.step(dt); }
};

int main() {
    workbook::Play table(
        "A sheet of 12 x 12 falls into its pins for 0.8 s; its springs may be longer by 0.1, and are by",
        {"on the way", "at the end"});
    table.timed("ns a step");
    workbook::Plot plot("play-soft_bodies.strain_limit", "How far the longest spring is stretched");
    plot.x("time", "s").y("strain");
    auto show = [&](const std::string& who, auto scene) {
        std::vector<double> times, strains;
        for (int i = 0; i < steps; ++i) {
            scene->step();
            times.push_back((i + 1) * dt.value());
            strains.push_back(largest_strain(scene->world));
        }
        plot.line(who, times, strains);
        table.row(who, {*std::max_element(strains.begin(), strains.end()), strains.back()}, 1,
                  [scene] { scene->step(); });
    };
    show("yours", std::make_shared<Yours>(40));
    show("library", std::make_shared<Library>(40));
    show("5 passes", std::make_shared<Yours>(5));
    show("none", std::make_shared<Yours>(0));
    plot.write();
    return table.print();
}
