// SPDX-License-Identifier: BSL-1.0
// The scene of section 3 with your law in it: a scale, whose pan hangs from a spring in a world.

#include "play.hpp"
#include "plot.hpp"
#include "subject.hpp"

#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

using Force = Quantity<unit::Force> (*)(Quantity<unit::Stiffness>, Quantity<unit::Length>);
using Energy = Quantity<unit::Energy> (*)(Quantity<unit::Stiffness>, Quantity<unit::Length>);

const auto k = 200.0 * newton_per_metre;
const auto dt = 1.0 / 240 * second;

struct Weighing {
    std::vector<Quantity<unit::Time>> times;
    std::vector<Quantity<unit::Length>> heights;
};

/// A pan of so many kilograms is let go where the spring rests, in a thick liquid, so that it hangs still soon.
Weighing weigh(Force force, double kilograms) {
    World scale{SemiImplicitEuler{}, Gravity{}, Drag{6.0 / second}, Keep<InverseMass>{}};
    const auto pan = scale.add(position(metres(0, 0, 0)), mass(kilograms * kilogram));
    Weighing w;
    for (int i = 0; i < 960; ++i) {
        w.times.push_back(scale.time());
        w.heights.push_back(y(scale.position(pan)));
        const auto pull = in(force(k, w.heights.back()), newton) * newtons(0, 1, 0);
        scale.apply_impulse(pan, pull * dt);
        scale.step(dt);
    }
    return w;
}

void show(const char* who, Force force, Energy energy, workbook::Play& table, workbook::Plot& plot) {
    const auto one = weigh(force, 1), two = weigh(force, 2);
    plot.line(who, two.times, two.heights);
    table.row(who, {one.heights.back().value(), two.heights.back().value(), energy(k, two.heights.back()).value()},
              1000, [force] {
                  static volatile double sink = 0;
                  for (int i = 0; i < 1000; ++i) sink = sink + force(k, 0.001 * i * metre).value();
              });
}

int main() {
    workbook::Play table("A pan hangs from a spring of 200 N/m. It should hang at -m g / k: -0.04905 m for 1 kg.",
                         {"1 kg hangs at, m", "2 kg hang at, m", "the spring holds, J"});
    table.timed("ns a call");
    workbook::Plot plot("play-springs.hooke", "A scale: yours and the library's");
    plot.x("time").y("place of the pan");
    show(
        "yours", [](auto s, auto x) { return exercise::force(s, x); },
        [](auto s, auto x) { return exercise::energy(s, x); }, table, plot);
    show(
        "library", [](auto s, auto x) { return springs::force(s, x); },
        [](auto s, auto x) { return springs::energy(s, x); }, table, plot);
    plot.write();
    return table.print();
}
