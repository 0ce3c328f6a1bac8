// SPDX-License-Identifier: BSL-1.0
// The scene of section 3.5 with your limit in it: a damped spring that is too stiff for 60 frames a second.

#include "play.hpp"
#include "plot.hpp"
#include "subject.hpp"

#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

const auto m = 2.0 * kilogram;
const auto k = 2e4 * newton_per_metre;
const auto c = 100.0 * newton_second_per_metre;
const auto frame = 1.0 / 60 * second;

template <class... More> auto world_with_a_spring(More... more) {
    World world{SemiImplicitEuler{}, Springs{}, more...};
    const auto body = world.add(position(metres(1.1, 0, 0)), mass(m));
    world.add(Spring{metres(0, 0, 0), body, k, c, 1.0 * metre});
    return world;
}

struct Run {
    std::vector<Quantity<unit::Time>> times;
    std::vector<Quantity<unit::Length>> displacements;
};
/// A third of a second, frame by frame; `take_frame(world)` takes one.
template <class World_, class Frame> Run run(World_ world, Frame take_frame) {
    Run r;
    for (int i = 0; i <= 20; ++i) {
        r.times.push_back(world.time());
        r.displacements.push_back(x(world.position(world.handles()[0])) - 1.0 * metre);
        take_frame(world);
    }
    return r;
}

void show(const char* who, const Run& r, Quantity<unit::Time> limit, double parts, std::function<void()> call,
          workbook::Play& table, workbook::Plot& plot) {
    plot.line(who, r.times, r.displacements);
    table.row(who, {1000 * limit.value(), parts, r.displacements.back().value()}, 1, call);
}

int main() {
    workbook::Play table("2 kg on a spring of 20000 N/m with a damping of 100 N s/m, let go 0.1 m from its rest, at 60 "
                         "frames a second. Without damping the limit would be 20 ms, and a frame would be one step.",
                         {"limit, ms", "substeps of a frame", "place after 1/3 s, m"});
    table.timed("ns a limit");
    workbook::Plot plot("play-springs.stable_step", "A stiff spring: divided by you and by the library");
    plot.x("time").y("displacement");

    static volatile double sink = 0;
    const auto limit = exercise::largest_step(m, k, c);
    const int parts = exercise::parts_of(frame, limit);
    const Run mine = run(world_with_a_spring(), [&](auto& world) {
        for (int i = 0; i < parts; ++i) world.step(frame / double(parts));
    });
    show(
        "yours", mine, limit, parts, [] { sink = sink + exercise::largest_step(m, k, c).value(); }, table, plot);

    auto divided = world_with_a_spring(StepLimit<Divide>{});
    const auto take_frame = [](auto& world) { world.step(frame); };
    const Run theirs = run(divided, take_frame);
    take_frame(divided);
    const auto asked = [world = divided] { sink = sink + stable_step(world).value(); };
    show("library", theirs, stable_step(divided), double(divided.tick()), asked, table, plot);
    plot.write();
    return table.print();
}
