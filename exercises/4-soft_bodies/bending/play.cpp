// SPDX-License-Identifier: BSL-1.0
// A hinge of section 4.6 with your angle and your forces: two triangles of four bodies that fly, and fold to and fro.

#include "play.hpp"
#include "plot.hpp"
#include "subject.hpp"

#include <ansatz/soft_bodies.hpp>
#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

#include <array>
#include <cmath>

using namespace ansatz;

const exercise::Corners start{metres(0, 0, 0), metres(0.2, 0, 0), metres(0.06, 0, -0.15), metres(0.11, -0.1, 0.08)};
const std::array<std::array<std::size_t, 2>, 5> sides{{{0, 1}, {0, 2}, {1, 2}, {0, 3}, {1, 3}}};
const auto body_mass = 0.002 * kilogram;
const auto along = 2000.0 * newton_per_metre;
const auto stiffness = 0.05 * joule;
const auto rest = degrees(-20.0);
const auto dt = 5e-5 * second;
const int steps = 8000;

/// The angle in degrees, every 20 steps.
std::vector<double> yours() {
    exercise::Corners x = start;
    std::array<VectorQuantity<unit::Velocity, 3>, 4> v;
    v.fill(metres_per_second(0, 0, 0));
    std::vector<double> angles;
    for (int n = 0; n < steps; ++n) {
        auto forces = exercise::forces(x, stiffness, rest);
        for (const auto& [a, b] : sides) {
            const auto to = x[b] - x[a];
            const VectorQuantity<unit::Force, 3> pull =
                along * (norm(to) - norm(start[b] - start[a])) * (to / norm(to));
            forces[a] += pull;
            forces[b] -= pull;
        }
        for (std::size_t i = 0; i < 4; ++i) {
            v[i] += dt / body_mass * forces[i];
            x[i] += dt * v[i];
        }
        if (n % 20 == 19) angles.push_back(in_degrees(exercise::angle(x)));
    }
    return angles;
}
std::vector<double> library() {
    World world{SemiImplicitEuler{}, Springs{}, Bending{}};
    std::array<Handle, 4> bodies;
    for (std::size_t i = 0; i < 4; ++i) bodies[i] = world.add(position(start[i]), mass(body_mass));
    for (const auto& [a, b] : sides) world.add(Spring{.first = bodies[a], .second = bodies[b], .stiffness = along});
    const auto hinge = world.add(
        Hinge{.edge = {bodies[0], bodies[1]}, .wings = {bodies[2], bodies[3]}, .stiffness = stiffness, .rest = rest});
    std::vector<double> angles;
    for (int n = 0; n < steps; ++n) {
        world.step(dt);
        if (n % 20 == 19) angles.push_back(in_degrees(hinge_angle(world, hinge)));
    }
    return angles;
}

int main() {
    workbook::Play table("Two triangles, folded by more than they rest at, are let go. What is their angle?",
                         {"after 1 ms, deg", "after 40 ms, deg", "after 400 ms, deg"});
    table.timed("ns a hinge");
    workbook::Plot plot("play-soft_bodies.bending", "A hinge that is let go: yours and the library's");
    plot.x("time", "s").y("angle", "degrees");
    std::vector<double> times;
    for (int n = 20; n <= steps; n += 20) times.push_back(n * dt.value());
    auto show = [&](const char* who, const std::vector<double>& angles, auto&& once) {
        plot.line(who, times, angles);
        table.row(who, {angles[0], angles[39], angles.back()}, 1, once);
    };
    show("yours", yours(), [&] {
        static volatile double sink = 0;
        sink = exercise::forces(start, stiffness, rest)[0].value()[0];
    });
    World world{SemiImplicitEuler{}, Bending{}};
    std::array<Handle, 4> bodies;
    for (std::size_t i = 0; i < 4; ++i) bodies[i] = world.add(position(start[i]), mass(1e6 * kilogram));
    world.add(
        Hinge{.edge = {bodies[0], bodies[1]}, .wings = {bodies[2], bodies[3]}, .stiffness = stiffness, .rest = rest});
    show("library", library(), [&] { world.step(1e-9 * second); });
    plot.write();
    return table.print();
}
