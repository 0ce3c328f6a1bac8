// SPDX-License-Identifier: BSL-1.0
// The scene of section 1.8 with your rest in it: a ball thrown up on a small moon, and a puck on rough ice.

#include "play.hpp"
#include "plot.hpp"
#include "subject.hpp"

#include <ansatz/world.hpp>

using namespace ansatz;

template <class Rest> void show(const char* who, workbook::Play& table, workbook::Plot& plot) {
    const Rest rest{0.05 * metre_per_second, 0.5 * second};
    World moon{SemiImplicitEuler{}, Gravity{metres_per_second_squared(0, -0.1, 0)}, rest};
    const auto ball = moon.add(velocity(metres_per_second(0, 1, 0)));
    std::vector<Quantity<unit::Time>> times;
    std::vector<Quantity<unit::Length>> heights;
    for (int i = 0; i <= 20 * 60; ++i) {
        times.push_back(moon.time());
        heights.push_back(y(moon.position(ball)));
        moon.step(1.0 / 60 * second);
    }
    plot.line(who, times, heights);

    World ice{SemiImplicitEuler{}, Drag{1.0 / second}, rest};
    const auto puck = ice.add(velocity(metres_per_second(1, 0, 0)));
    while (ice.time() < 10.0 * second && ice.motion(puck) != Motion::resting) ice.step(1.0 / 60 * second);

    World many{SemiImplicitEuler{}, rest};
    for (int i = 0; i < 1000; ++i) many.add(velocity(metres_per_second(1 + i, 0, 0)));
    table.row(who, {heights.back().value(), double(ice.time() / second), x(ice.position(puck)).value()}, 1000,
              [many]() mutable { many.step(1e-3 * second); });
}

int main() {
    workbook::Play table(
        "A ball thrown up with 1 m/s where g = 0.1 m/s^2, back at 0 m after 20 s; and a puck with 1 m/s under "
        "a drag of 1/s.\nIt is below 0.05 m/s after 3 s and sleeps half a second later.",
        {"ball after 20 s, m", "puck asleep after, s", "puck at, m"});
    workbook::Plot plot("play-motion.rest", "Rest: yours and the library's");
    plot.x("time").y("height");
    show<exercise::Rest>("yours", table, plot);
    show<ansatz::Rest>("library", table, plot);
    plot.write();
    return table.print();
}
