// SPDX-License-Identifier: BSL-1.0
// The scene of section 4.4 with your vertex in it: a rope of twenty bodies hangs from its two ends, one body solved
// after the other, four times a frame.

#include "play.hpp"
#include "plot.hpp"
#include "subject.hpp"

#include <ansatz/soft_bodies.hpp>
#include <ansatz/springs.hpp>

using namespace ansatz;

const int links = 20, frames = 120;
const auto length = 0.1 * metre;
const auto stiffness = 500.0 * newton_per_metre;
const auto body_mass = 0.02 * kilogram;
const auto frame = 1.0 / 60 * second;

/// How deep the middle hangs, frame by frame.
std::vector<double> yours(int iterations) {
    std::vector<exercise::Place> x;
    std::vector<VectorQuantity<unit::Velocity, 3>> v(links + 1, metres_per_second(0, 0, 0));
    for (int i = 0; i <= links; ++i) x.push_back(metres(0.1 * i, 0, 0));
    std::vector<double> depths;
    for (int n = 0; n < frames; ++n) {
        for (std::size_t i = 1; i < links; ++i) {
            v[i] += frame * metres_per_second_squared(0, -9.81, 0);
            x[i] += frame * v[i];
        }
        const auto flown = x;
        for (int turn = 0; turn < iterations; ++turn)
            for (std::size_t i = 1; i < links; ++i) {
                // One step of Newton from where it is: from there, as if it had flown there and were drawn to `flown`.
                const exercise::Body body{body_mass, flown[i]};
                const std::vector<exercise::Spring> springs = {{x[i - 1], length, stiffness},
                                                               {x[i + 1], length, stiffness}};
                const Eigen::Vector3d slope = exercise::slope(body, x[i], springs, frame).value();
                x[i] -= exercise::Place::from_value(exercise::curvature(body, x[i], springs, frame).inverse() * slope);
            }
        for (std::size_t i = 1; i < links; ++i) v[i] += (x[i] - flown[i]) / frame;
        depths.push_back(-x[links / 2].value()[1]);
    }
    return depths;
}
std::vector<double> library(int iterations) {
    World world{SemiImplicitEuler{}, Gravity{}, Springs{}, VertexBlockDescent{.substeps = 1, .iterations = iterations}};
    std::vector<Handle> bodies;
    for (int i = 0; i <= links; ++i) {
        const auto at = position(metres(0.1 * i, 0, 0));
        bodies.push_back(i == 0 || i == links ? world.add(at, fixed) : world.add(at, mass(body_mass)));
    }
    for (std::size_t i = 0; i < links; ++i)
        world.add(Spring{.first = bodies[i], .second = bodies[i + 1], .stiffness = stiffness, .rest_length = length});
    std::vector<double> depths;
    for (int n = 0; n < frames; ++n) {
        world.step(frame);
        depths.push_back(-y(world.position(bodies[links / 2])).value());
    }
    return depths;
}

int main() {
    workbook::Play table("A rope of 20 links between two points 2 m apart, after 2 s of 60 frames each.",
                         {"4 iterations, m", "100 iterations, m"});
    table.timed("ns a vertex");
    workbook::Plot plot("play-soft_bodies.vertex_block_descent", "How deep the middle of a rope hangs, 4 iterations");
    plot.x("time", "s").y("depth", "m");
    std::vector<double> times;
    for (int n = 0; n < frames; ++n) times.push_back((n + 1) / 60.0);
    auto show = [&](const char* who, const auto& run, int vertices, auto&& once) {
        const auto few = run(4), many = run(100);
        plot.line(who, times, few);
        table.row(who, {few.back(), many.back()}, vertices, once);
    };
    const exercise::Body body{body_mass, metres(0, 0, 0)};
    const std::vector<exercise::Spring> springs = {{metres(0.1, 0.02, 0), length, stiffness},
                                                   {metres(-0.1, 0.01, 0), length, stiffness}};
    show("yours", yours, 100, [&] {
        static volatile double sink = 0;
        sink = exercise::solve(body, springs, frame, 100).value()[0];
    });
    World world{SemiImplicitEuler{}, Springs{}, VertexBlockDescent{.substeps = 1, .iterations = 100}};
    const auto middle = world.add(position(metres(0, 0, 0)), mass(body_mass));
    for (const double side : {-0.1, 0.1})
        world.add(Spring{.first = world.add(position(metres(side, 0.02, 0)), fixed),
                         .second = middle,
                         .stiffness = stiffness,
                         .rest_length = length});
    show("library", library, 100, [&] { world.step(frame); });
    plot.write();
    return table.print();
}
