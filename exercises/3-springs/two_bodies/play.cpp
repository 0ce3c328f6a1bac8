// SPDX-License-Identifier: BSL-1.0
// The pair of section 3.2: where yours says that it is, beside a World with Springs that gets there in steps.

#include "play.hpp"
#include "plot.hpp"
#include "subject.hpp"

#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

using Time = Quantity<unit::Time>;
using Length = Quantity<unit::Length>;

const auto k = 100.0 * newton_per_metre;
const auto rest_length = 1.0 * metre;
const exercise::Pair beginning{{1.0 * kilogram, 0.0 * metre, 0.5 * metre_per_second},
                               {3.0 * kilogram, 1.4 * metre, 0.0 * metre_per_second},
                               k,
                               rest_length};
const auto dt = 1.0 / 1000 * second;

int main() {
    World space{VelocityVerlet{}, Springs<Undamped>{}};
    const auto a = space.add(position(metres(0, 0, 0)), velocity(metres_per_second(0.5, 0, 0)), mass(1.0 * kilogram));
    const auto b = space.add(position(metres(1.4, 0, 0)), mass(3.0 * kilogram));
    space.add(Spring{a, b, k, {}, rest_length});

    std::vector<Time> times;
    std::vector<Length> light, heavy, stepped_light, stepped_heavy;
    for (int i = 0; i <= 3000; ++i) {
        if (i > 0) space.step(dt);
        if (i % 10 > 0) continue;
        times.push_back(double(i) * dt);
        const exercise::Pair now = exercise::after(beginning, times.back());
        light.push_back(now.first.place), heavy.push_back(now.second.place);
        stepped_light.push_back(x(space.position(a))), stepped_heavy.push_back(x(space.position(b)));
    }
    workbook::Play table(
        "1 kg and 3 kg on a spring of 100 N/m after 3 s: by your formula, and in a World after 3000 steps",
        {"1 kg, m", "3 kg, m", "a swing, s"});
    table.timed("ns for a place");
    volatile double sink = 0;
    table.row("yours",
              {light.back().value(), heavy.back().value(), exercise::period(1.0 * kilogram, 3.0 * kilogram, k).value()},
              1000, [&sink] {
                  for (int i = 0; i < 1000; ++i)
                      sink = sink + exercise::after(beginning, double(i) * dt).first.place.value();
              });
    const auto period = 1.0 / springs::frequency(k, springs::reduced_mass(1.0 * kilogram, 3.0 * kilogram));
    table.row("library", {stepped_light.back().value(), stepped_heavy.back().value(), period.value()}, 1000,
              [space]() mutable {
                  for (int i = 0; i < 1000; ++i) space.step(dt);
              });
    workbook::Plot plot("play-springs.two_bodies", "Two bodies on a spring: your formula, and the library's steps");
    plot.x("time").y("place");
    plot.line("1 kg, yours", times, light).line("3 kg, yours", times, heavy);
    plot.reference("1 kg, in steps", times, stepped_light).reference("3 kg, in steps", times, stepped_heavy);
    plot.write();
    return table.print();
}
