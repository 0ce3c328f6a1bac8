// SPDX-License-Identifier: BSL-1.0
// The fall of section 3.4 on your rope, in a World, beside the library's; and whether a World agrees with your peak.

#include "play.hpp"
#include "plot.hpp"
#include "subject.hpp"

#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

using Force = Quantity<unit::Force>;
using Pull = Force (*)(Quantity<unit::Length>, Quantity<unit::Velocity>);

const auto load = 80.0 * kilogram;
const auto g = 9.81 * metre_per_second_squared;
const auto k = 1500.0 * newton_per_metre;
const auto c = 60.0 * newton_second_per_metre;
const auto rest_length = 4.0 * metre;

Force yours(Quantity<unit::Length> length, Quantity<unit::Velocity> lengthens) {
    return exercise::pull(length, rest_length, lengthens, k, c);
}
Force library(Quantity<unit::Length> length, Quantity<unit::Velocity> lengthens) {
    return springs::tension<springs::Acts::pulling>(length, rest_length, lengthens, k, c);
}

/// The climber of the section falls past a wall, on a damped rope, and is thrown up again until the rope is slack.
struct Fall {
    std::vector<Quantity<unit::Time>> times;
    std::vector<Force> pulls;
    Force peak = 0.0 * newton;
    Quantity<unit::Length> lowest = 0.0 * metre;
};
Fall fall(Pull pull) {
    World wall{SemiImplicitEuler{}, Gravity{metres_per_second_squared(0, -9.81, 0)}, Keep<InverseMass>{}};
    const auto climber = wall.add(position(metres(0, -0.01, 0)), mass(load));
    const auto dt = 1.0 / 2000 * second;
    Fall result;
    while (wall.time() < 4.0 * second) {
        const Force up = pull(norm(wall.position(climber)), -y(wall.velocity(climber)));
        wall.apply_impulse(climber, newtons(0, up.value(), 0) * dt);
        wall.step(dt);
        result.times.push_back(wall.time());
        result.pulls.push_back(up);
        result.peak = max(result.peak, up);
        result.lowest = min(result.lowest, y(wall.position(climber)));
    }
    return result;
}
/// The hardest pull of a rope without damping, as a World with Ropes finds it in small steps.
Force looked_for() {
    World wall{VelocityVerlet{}, Gravity{metres_per_second_squared(0, -9.81, 0)}, Ropes<>{}};
    const auto climber = wall.add(position(metres(0, 0, 0)), mass(load));
    wall.add(Rope{.first = metres(0, 0, 0), .second = climber, .stiffness = k, .rest_length = rest_length});
    Force peak = 0.0 * newton;
    while (wall.time() < 2.0 * second) {
        wall.step(1.0 / 20000 * second);
        peak = max(peak, Force(k * (norm(wall.position(climber)) - rest_length)));
    }
    return peak;
}

int main() {
    workbook::Play table(
        "80 kg fall 4 m onto a rope of 1500 N/m: with a damping of 60 N s/m on your rope; and without, by "
        "your formula, beside what a World with Ropes finds",
        {"damped: peak, N", "lowest point, m", "undamped: peak, N"});
    table.timed("ns a call");
    workbook::Plot plot("play-springs.rope", "A fall on a damped rope: yours and the library's");
    plot.x("time").y("pull of the rope");
    volatile double sink = 0;
    auto show = [&](const char* who, Pull pull, Force undamped) {
        const Fall result = fall(pull);
        plot.line(who, result.times, result.pulls);
        table.row(who, {result.peak.value(), result.lowest.value(), undamped.value()}, 1000, [&sink, pull] {
            for (int i = 0; i < 1000; ++i)
                sink = sink + pull((3.5 + 0.001 * i) * metre, 1.0 * metre_per_second).value();
        });
    };
    show("yours", yours, exercise::peak_pull(load, g, sqrt(2.0 * g * rest_length), k));
    show("library", library, looked_for());
    plot.write();
    return table.print();
}
