// SPDX-License-Identifier: BSL-1.0
// The scene of section 4.4 with your constraint in it: a chain of twenty stiff links hangs from its first, and each
// link is corrected 32 times a frame, as substeps or as iterations.

#include "play.hpp"
#include "plot.hpp"
#include "subject.hpp"

#include <ansatz/soft_bodies.hpp>
#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

#include <cmath>

using namespace ansatz;

const int links = 20, frames = 120;
const auto length = 0.1 * metre;
const auto stiffness = 1e5 * newton_per_metre;
const auto frame = 1.0 / 60 * second;

/// How long the chain is, frame by frame.
std::vector<double> yours(int substeps, int iterations) {
    std::vector<exercise::End> ends;
    for (int i = 0; i <= links; ++i)
        ends.push_back({double(i) * length.value() * metres(0, -1, 0), metres_per_second(0, 0, 0),
                        (i > 0 ? 20.0 : 0.0) / kilogram});
    const auto h = frame / double(substeps);
    std::vector<double> lengths;
    for (int n = 0; n < frames; ++n) {
        for (int part = 0; part < substeps; ++part) {
            for (auto& end : ends) {
                if (end.inverse_mass > 0.0 / kilogram) end.velocity += h * metres_per_second_squared(0, -9.81, 0);
                end.position += h * end.velocity;
            }
            std::vector<exercise::Multiplier> given(links, 0.0 * kilogram * metre);
            for (int iteration = 0; iteration < iterations; ++iteration)
                for (int i = 0; i < links; ++i)
                    given[i] = exercise::hold(ends[i], ends[i + 1], {length, stiffness}, given[i], h);
        }
        lengths.push_back(-ends.back().position.value()[1]);
    }
    return lengths;
}
std::vector<double> library(int substeps, int iterations) {
    World world{SemiImplicitEuler{}, Gravity{}, Springs{}, Xpbd{.substeps = substeps, .iterations = iterations}};
    std::vector<Handle> bodies;
    for (int i = 0; i <= links; ++i) {
        const auto at = position(double(i) * length.value() * metres(0, -1, 0));
        bodies.push_back(i > 0 ? world.add(at, mass(0.05 * kilogram)) : world.add(at, fixed));
    }
    for (int i = 0; i < links; ++i)
        world.add(Spring{.first = bodies[i], .second = bodies[i + 1], .stiffness = stiffness, .rest_length = length});
    std::vector<double> lengths;
    for (int n = 0; n < frames; ++n) {
        world.step(frame);
        lengths.push_back(-y(world.position(bodies.back())).value());
    }
    return lengths;
}

int main() {
    workbook::Play table("A chain of 20 links, 2 m and 1 kg, hangs for 2 s, 32 corrections of each link a frame.",
                         {"32 substeps, m", "32 iterations, m"});
    table.timed("ns a call");
    workbook::Plot plot("play-soft_bodies.xpbd", "How long a chain is that is corrected in 32 substeps");
    plot.x("time", "s").y("length", "m");
    std::vector<double> times;
    for (int n = 0; n < frames; ++n) times.push_back((n + 1) / 60.0);
    auto show = [&](const char* who, const auto& run, auto&& thousand) {
        const auto substeps = run(32, 1), iterations = run(1, 32);
        plot.line(who, times, substeps);
        table.row(who, {substeps.back(), iterations.back()}, 1000, thousand);
    };
    exercise::End top{metres(0, 0, 0), metres_per_second(0, 0, 0), 0.0 / kilogram},
        body{metres(0, -0.1, 0), metres_per_second(0, 0, 0), 20.0 / kilogram};
    show("yours", yours, [&] {
        for (int i = 0; i < 1000; ++i)
            exercise::hold(top, body, {length, stiffness}, 0.0 * kilogram * metre, 1e-3 * second);
    });
    World world{SemiImplicitEuler{}, Gravity{}, Springs{}, Xpbd{.substeps = 1000}};
    world.add(Spring{.first = world.add(position(metres(0, 0, 0)), fixed),
                     .second = world.add(position(metres(0, -0.1, 0)), mass(0.05 * kilogram)),
                     .stiffness = stiffness,
                     .rest_length = length});
    show("library", library, [&] { world.step(frame); });
    plot.write();
    return table.print();
}
