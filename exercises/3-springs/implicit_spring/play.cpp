// SPDX-License-Identifier: BSL-1.0
// The scene of section 3.5 with your step in it: a spring that is far too stiff for 60 steps a second.

#include "play.hpp"
#include "plot.hpp"
#include "subject.hpp"

#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

const auto m = 1.0 * kilogram;
const auto k = 1000.0 * newton_per_metre;
const auto c = 2.0 * newton_second_per_metre;
const auto dt = 1.0 / 60 * second;

struct Run {
    std::vector<Quantity<unit::Time>> times;
    std::vector<Quantity<unit::Length>> displacements;
    /// For a row of the table: where it is after a tenth of a second, and after half a second.
    std::vector<double> numbers() const { return {displacements[6].value(), displacements[30].value()}; }
};

Run yours() {
    const exercise::OnSpring body{m, k, c};
    exercise::State state{0.1 * metre, 0.0 * metre_per_second};
    Run run;
    for (int i = 0; i <= 60; ++i) {
        run.times.push_back(double(i) * dt);
        run.displacements.push_back(state.x);
        state = exercise::after_a_step(body, state, dt);
    }
    return run;
}

/// A real world with a spring of 1 m in it, solved by the library.
auto world_with_a_spring() {
    World world{Space<double, 2>{}, ImplicitEuler{}, Springs{}};
    const auto body = world.add(position(metres(1.1, 0)), mass(m));
    world.add(Spring{metres(0, 0), body, k, c, 1.0 * metre});
    return world;
}
Run library() {
    auto world = world_with_a_spring();
    const auto body = world.handles()[0];
    Run run;
    for (int i = 0; i <= 60; ++i) {
        run.times.push_back(world.time());
        run.displacements.push_back(x(world.position(body)) - 1.0 * metre);
        world.step(dt);
    }
    return run;
}

int main() {
    workbook::Play table("1 kg on a spring of 1000 N/m, let go 0.1 m from its rest, at 60 steps a second.",
                         {"place after 0.1 s, m", "place after 0.5 s, m"});
    workbook::Plot plot("play-springs.implicit_spring", "A stiff spring: your step and the library's world");
    plot.x("time").y("displacement");
    const Run mine = yours(), theirs = library();
    plot.line("yours", mine.times, mine.displacements).line("library", theirs.times, theirs.displacements);
    table.row("yours", mine.numbers(), 1000, [] {
        static volatile double sink = 0;
        exercise::State state{0.1 * metre, 0.0 * metre_per_second};
        for (int i = 0; i < 1000; ++i) state = exercise::after_a_step({m, k, c}, state, dt);
        sink = sink + state.x.value();
    });
    table.row("library", theirs.numbers(), 1, [world = world_with_a_spring()]() mutable { world.step(dt); });
    plot.write();
    return table.print();
}
