// SPDX-License-Identifier: BSL-1.0
// The scene of section 4.5 with your air in it: a ball of springs along its skin is blown up, and swings to its size.

#include "play.hpp"
#include "plot.hpp"
#include "subject.hpp"

#include <ansatz/soft_bodies.hpp>
#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

const TriangleMesh ball = ball_mesh(0.2 * metre, 2);
const exercise::Triangles triangles(ball.triangles().begin(), ball.triangles().end());
const auto body_mass = 0.005 * kilogram;
const auto stiffness = 2000.0 * newton_per_metre;
const auto damping = 0.2 * newton_second_per_metre;
const auto inside = 125000.0 * pascal, outside = 101325.0 * pascal;
const auto dt = 1e-4 * second;
const int steps = 3000;

/// The volume of the ball, every 10 steps.
std::vector<double> yours() {
    exercise::Points x(ball.vertices().begin(), ball.vertices().end());
    std::vector<VectorQuantity<unit::Velocity, 3>> v(x.size(), metres_per_second(0, 0, 0));
    std::vector<double> volumes;
    for (int n = 0; n < steps; ++n) {
        auto forces = exercise::forces(
            x, triangles, exercise::pressure({inside, ball.volume(), outside}, exercise::volume(x, triangles)));
        for (const auto& [a, b] : ball.edges()) {
            const auto to = x[b] - x[a];
            const auto rest = norm(ball.vertices()[b] - ball.vertices()[a]);
            const auto rate = dot(v[b] - v[a], to) / norm(to);
            const VectorQuantity<unit::Force, 3> pull =
                (stiffness * (norm(to) - rest) + damping * rate) * (to / norm(to));
            forces[a] += pull;
            forces[b] -= pull;
        }
        for (std::size_t i = 0; i < x.size(); ++i) {
            v[i] += dt / body_mass * forces[i];
            x[i] += dt * v[i];
        }
        if (n % 10 == 9) volumes.push_back(exercise::volume(x, triangles).value());
    }
    return volumes;
}
std::vector<double> library() {
    World world{SemiImplicitEuler{}, Springs{}, Pressure{}};
    std::vector<Handle> bodies;
    for (const auto& x : ball.vertices()) bodies.push_back(world.add(position(x), mass(body_mass)));
    for (const auto& [a, b] : ball.edges())
        world.add(Spring{.first = bodies[a], .second = bodies[b], .stiffness = stiffness, .damping = damping});
    const auto air = world.add(Enclosure::of(bodies, ball, {.inside = inside, .outside = outside}));
    std::vector<double> volumes;
    for (int n = 0; n < steps; ++n) {
        world.step(dt);
        if (n % 10 == 9) volumes.push_back(enclosed_volume(world, air).value());
    }
    return volumes;
}

int main() {
    workbook::Play table("A ball of 66 bodies is blown up by 23675 Pa. What is its volume?",
                         {"after 1 ms, l", "after 10 ms, l", "after 300 ms, l"});
    table.timed("ns a vertex");
    workbook::Plot plot("play-soft_bodies.pressure", "A ball that is blown up: yours and the library's");
    plot.x("time", "s").y("volume", "m^3");
    std::vector<double> times;
    for (int n = 10; n <= steps; n += 10) times.push_back(n * dt.value());
    auto show = [&](const char* who, const std::vector<double>& volumes, auto&& once) {
        plot.line(who, times, volumes);
        table.row(who, {1000 * volumes[0], 1000 * volumes[9], 1000 * volumes.back()}, int(ball.vertices().size()),
                  once);
    };
    const exercise::Points x(ball.vertices().begin(), ball.vertices().end());
    show("yours", yours(), [&] {
        static volatile double sink = 0;
        sink = exercise::forces(x, triangles, 1.0 * pascal)[0].value()[0];
    });
    World world{SemiImplicitEuler{}, Pressure{}};
    std::vector<Handle> bodies;
    for (const auto& at : ball.vertices()) bodies.push_back(world.add(position(at), mass(1e6 * kilogram)));
    world.add(Enclosure::of(bodies, ball, {.inside = inside, .outside = outside}));
    show("library", library(), [&] { world.step(1e-9 * second); });
    plot.write();
    return table.print();
}
