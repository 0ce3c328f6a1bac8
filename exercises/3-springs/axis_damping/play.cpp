// SPDX-License-Identifier: BSL-1.0
// The scene of section 3 with your damper in it: a pendulum on a damped spring, in a world.

#include "play.hpp"
#include "plot.hpp"
#include "subject.hpp"

#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

#include <algorithm>

using namespace ansatz;

using exercise::Damped;
using exercise::End;
using exercise::Force;
using Forces = std::pair<Force, Force> (*)(const End&, const End&, const Damped&);

const Damped spring{1.0 * metre, 1e5 * newton_per_metre, 600.0 * newton_second_per_metre};

std::pair<Force, Force> library(const End& first, const End& second, const Damped& s) {
    const Force on_first = springs::between(second.position - first.position, second.velocity - first.velocity,
                                            s.rest_length, s.stiffness, s.damping);
    return {on_first, -on_first};
}

/// Let go at the height of its hook, the bob swings for 20 s.
struct Swing {
    std::vector<Quantity<unit::Time>> times;
    std::vector<Quantity<unit::Length>> heights;
    Quantity<unit::Length> longest = 0.0 * metre;
    Quantity<unit::Length> rises_to() const { return *std::max_element(heights.end() - 2000, heights.end()); }
};
Swing swing(Forces forces) {
    World world{SemiImplicitEuler{}, Gravity{}, Keep<InverseMass>{}};
    const auto bob = world.add(position(metres(1, 0, 0)), mass(1.0 * kilogram));
    const End hook{metres(0, 0, 0), metres_per_second(0, 0, 0)};
    const auto dt = 1.0 / 1000 * second;
    Swing s;
    for (int i = 0; i < 20000; ++i) {
        s.times.push_back(world.time());
        s.heights.push_back(y(world.position(bob)));
        s.longest = max(s.longest, norm(world.position(bob)));
        world.apply_impulse(bob, forces(hook, {world.position(bob), world.velocity(bob)}, spring).second * dt);
        world.step(dt);
    }
    return s;
}

void show(const char* who, Forces forces, workbook::Play& table, workbook::Plot& plot) {
    const Swing s = swing(forces);
    plot.line(who, s.times, s.heights);
    table.row(who, {s.rises_to().value(), s.longest.value()}, 1000, [forces] {
        static volatile double sink = 0;
        for (int i = 0; i < 1000; ++i)
            sink = sink + x(forces({metres(0, 0, 0), metres_per_second(0, 0, 0)},
                                   {metres(1, i, 0), metres_per_second(0, 1, 0)}, spring)
                                .first)
                              .value();
    });
}

int main() {
    workbook::Play table(
        "A pendulum of 1 m on a damped spring, let go at the height of its hook, swings for 20 s. With all of its "
        "velocity damped it would hang at -1 m.",
        {"in the end it rises to, m", "the spring's longest, m"});
    table.timed("ns a call");
    workbook::Plot plot("play-springs.axis_damping", "A pendulum on a damped spring: yours and the library's");
    plot.x("time").y("height of the bob");
    show(
        "yours", [](const End& a, const End& b, const Damped& s) { return exercise::forces(a, b, s); }, table, plot);
    show("library", library, table, plot);
    plot.write();
    return table.print();
}
