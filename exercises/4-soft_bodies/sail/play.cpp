// SPDX-License-Identifier: BSL-1.0
// A stiff sheet that falls in still air, flat, slanting or steep, with your forces on it and with the library's.

#include "play.hpp"
#include "plot.hpp"
#include "subject.hpp"

#include <ansatz/soft_bodies/wind.hpp>
#include <ansatz/world.hpp>

#include <memory>
#include <string>
#include <utility>
#include <vector>

using namespace ansatz;

const exercise::Air air{1.2 * kilogram_per_cubic_metre, 1.2, 0.8};
const auto corner_mass = 0.02 * kilogram;
const auto dt = 0.01 * second;
const int steps = 300;

/// A sheet of one square metre whose second and third corners lie lower than the others.
exercise::Cloth sheet(double lower) {
    return {{metres(0, 0, 0), metres(0, -lower, 1), metres(1, -lower, 1), metres(1, 0, 0)},
            std::vector<exercise::Speed>(4, metres_per_second(0, 0, 0)),
            {{0, 1, 2}, {0, 2, 3}}};
}
/// A board: all of its points move alike.
struct Yours {
    exercise::Cloth cloth;
    exercise::Speed velocity = metres_per_second(0, 0, 0);
    void step() {
        auto force = newtons(0, 0, 0);
        for (const auto& f : exercise::blow(cloth, metres_per_second(0, 0, 0), air)) force += f;
        velocity += dt * (force / (4.0 * corner_mass) + metres_per_second_squared(0, -9.81, 0));
        for (auto& v : cloth.velocities) v = velocity;
        for (auto& x : cloth.points) x += dt * velocity;
    }
    double speed() const { return -velocity.value()[1]; }
    double aside() const { return cloth.points[0].value()[2]; }
};

/// The same in a world: after each step all bodies go on with their mean.
struct Library {
    World<SemiImplicitEuler, Gravity, Wind> world{SemiImplicitEuler{}, Gravity{}, Wind{.density = air.density}};
    exercise::Cloth at;
    std::vector<Handle> bodies;
    exercise::Speed velocity = metres_per_second(0, 0, 0);
    explicit Library(const exercise::Cloth& cloth) : at(cloth) {
        for (const auto& x : cloth.points) bodies.push_back(world.add(position(x), mass(corner_mass)));
        for (const auto& [a, b, c] : cloth.triangles)
            world.add(Sail{{bodies[a], bodies[b], bodies[c]}, air.drag, air.lift});
    }
    void step() {
        world.step(dt);
        velocity = metres_per_second(0, 0, 0);
        for (const auto body : bodies) velocity += world.velocity(body) / 4.0;
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            at.points[i] += dt * velocity;
            world.set_velocity(bodies[i], velocity);
            world.set_position(bodies[i], at.points[i]);
        }
    }
    double speed() const { return -velocity.value()[1]; }
    double aside() const { return at.points[0].value()[2]; }
};

int main() {
    workbook::Play table(
        "A stiff sheet of 80 g falls for 3 s in still air, slanting, and yours flat and steep, too. Then:",
        {"falls with, m/s", "carried aside, m"});
    table.timed("ns a step");
    workbook::Plot plot("play-soft_bodies.sail", "How far a sheet falls, by how it is turned");
    plot.x("time", "s").y("height", "m");
    auto show = [&](const std::string& who, auto sheet, auto&& height) {
        std::vector<double> times, heights;
        for (int n = 0; n < steps; ++n) {
            sheet->step();
            times.push_back((n + 1) * dt.value());
            heights.push_back(height());
        }
        plot.line(who, times, heights);
        table.row(who, {sheet->speed(), sheet->aside()}, 1, [sheet] { sheet->step(); });
    };
    for (const auto& [turned, lower] : {std::pair("yours", 0.6), std::pair("flat", 0.0), std::pair("steep", 1.7)}) {
        const auto yours = std::make_shared<Yours>(Yours{sheet(lower)});
        show(turned, yours, [&] { return yours->cloth.points[0].value()[1]; });
        if (lower != 0.6) continue;
        const auto library = std::make_shared<Library>(sheet(lower));
        show("library", library, [&] { return library->at.points[0].value()[1]; });
    }
    plot.write();
    return table.print();
}
