// SPDX-License-Identifier: BSL-1.0
// The table of chapter 4 with your net in it: rows of bodies, their bound and what they really swing with.

#include "play.hpp"
#include "plot.hpp"
#include "subject.hpp"

#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

const auto weight = 10.0 / kilogram;
const auto stiffness = 200.0 * newton_per_metre;

exercise::Net row(std::size_t count) {
    exercise::Net net;
    net.weights.assign(count, weight);
    for (std::size_t i = 0; i + 1 < count; ++i) net.springs.push_back({i, i + 1, stiffness});
    return net;
}
auto world(std::size_t count) {
    World world{SemiImplicitEuler{}, Springs{}};
    std::vector<Handle> bodies;
    for (std::size_t i = 0; i < count; ++i)
        bodies.push_back(world.add(position(metres(double(i), 0, 0)), mass(1.0 / weight)));
    for (std::size_t i = 0; i + 1 < count; ++i)
        world.add(Spring{.first = bodies[i], .second = bodies[i + 1], .stiffness = stiffness});
    return world;
}

int main() {
    workbook::Play table("Rows of bodies of 0.1 kg on springs of 200 N/m, free at both ends.",
                         {"bound of 10, 1/s^2", "measured, 1/s^2", "its step, ms"});
    table.timed("ns a body");
    workbook::Plot plot("play-soft_bodies.sheet_step", "What a row of bodies swings with: yours and the library's");
    plot.x("bodies", "").y("largest omega^2", "1/s^2");
    auto show = [&](const char* who, auto&& measured, double bound, double step, auto&& once) {
        std::vector<double> counts, each;
        for (std::size_t n = 2; n <= 20; ++n) {
            counts.push_back(double(n));
            each.push_back(measured(n));
        }
        plot.line(who, counts, each);
        table.row(who, {bound, each[8], 1000 * step}, 10, once);
    };
    const auto net = row(10);
    show(
        "yours", [](std::size_t n) { return exercise::measured(row(n)).value(); }, exercise::bound(net).value(),
        exercise::longest_step(exercise::bound(net)).value(),
        [&] {
            static volatile double sink = 0;
            sink = exercise::bound(net).value();
        });
    const auto ten = world(10);
    show(
        "library", [](std::size_t n) { return measured_stiffness(world(n), 4000).value(); },
        stiffness_of(ten).largest.value(), stable_step(ten).value(),
        [&] {
            static volatile double sink = 0;
            sink = stiffness_of(ten).largest.value();
        });
    plot.write();
    return table.print();
}
