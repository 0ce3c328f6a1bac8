// SPDX-License-Identifier: BSL-1.0
// A ball is thrown along a soft surface, and lies in it at last: with your contact, whose forces are applied to the
// bodies of a world, and with the library's.

#include "play.hpp"
#include "plot.hpp"
#include "subject.hpp"

#include <ansatz/springs.hpp>
#include <ansatz/water/soft_surface.hpp>
#include <ansatz/water/surface_contacts.hpp>
#include <ansatz/world.hpp>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

using namespace ansatz;

const std::size_t n = 40;
const auto width = 0.25 * metre, radius = 0.4 * metre;
const auto dt = 1.0 / 240 * second;
const int steps = 1200;
const exercise::Contact contact{700.0 * newton_per_metre, 25.0 * newton_second_per_metre};

template <class World_> SoftSurfaceParts fill(World_& world) {
    return add_soft_surface(world, {.grid = ColumnGrid(n, 1, width, width).at(-0.5 * width, -0.5 * width),
                                    .mass_per_area = 50.0 * kilogram / square_metre,
                                    .tension = 2000.0 * newton_per_metre,
                                    .damping = 4.0 / second});
}
template <class World_> Handle throw_ball(World_& world) {
    return world.add(position(metres(1, 0.9)), velocity(metres_per_second(1, 0)), mass(8.0 * kilogram));
}

struct Yours {
    World<Space<double, 2>, SemiImplicitEuler, Gravity, Springs<>, AppliedForces> world{
        Space<double, 2>{}, SemiImplicitEuler{}, Gravity{}, Springs{}, AppliedForces{}};
    SoftSurfaceParts pond = fill(world);
    Handle ball = throw_ball(world);
    exercise::Contact with;
    explicit Yours(const exercise::Contact& by) : with(by) {}
    void step() {
        exercise::Surface surface{width, {}, {}};
        for (const auto column : pond.bodies) {
            surface.heights.push_back(y(world.position(column)));
            surface.rises.push_back(y(world.velocity(column)));
        }
        const auto forces = exercise::carry(surface, {world.position(ball), world.velocity(ball), radius}, with);
        world.apply_force(ball, forces.on_body);
        for (std::size_t i = 0; i < pond.bodies.size(); ++i)
            world.apply_force(pond.bodies[i], forces.on_columns[i] * Eigen::Vector2d(0, 1));
        world.step(dt);
    }
};
struct Library {
    World<Space<double, 2>, SemiImplicitEuler, Gravity, Springs<>, SurfaceContacts> world{
        Space<double, 2>{}, SemiImplicitEuler{}, Gravity{}, Springs{}, SurfaceContacts{}};
    Handle ball;
    Library() {
        const auto pond = fill(world);
        ball = throw_ball(world);
        world.add(SurfaceContact::of(pond, ball, {contact.stiffness, contact.damping, 10.0 * metre}, radius));
    }
    void step() { world.step(dt); }
};

int main() {
    workbook::Play table("A ball of 8 kg is thrown along a soft surface. After 5 s:",
                         {"its height, m", "how far, m", "lowest, m"});
    table.timed("ns a step");
    workbook::Plot plot("play-water.one_contact", "A ball on a soft surface");
    plot.x("how far", "m").y("height", "m");
    auto show = [&](const std::string& who, auto scene) {
        std::vector<double> far, heights;
        for (int i = 0; i < steps; ++i) {
            scene->step();
            const auto at = scene->world.position(scene->ball);
            far.push_back(x(at) / metre);
            heights.push_back(y(at) / metre);
        }
        plot.line(who, far, heights);
        table.row(who, {heights.back(), far.back(), *std::min_element(heights.begin(), heights.end())}, 1,
                  [scene] { scene->step(); });
    };
    show("yours", std::make_shared<Yours>(contact));
    show("library", std::make_shared<Library>());
    show("no damping", std::make_shared<Yours>(exercise::Contact{contact.stiffness, 0.0 * newton_second_per_metre}));
    plot.write();
    return table.print();
}
