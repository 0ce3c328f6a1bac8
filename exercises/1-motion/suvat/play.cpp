// SPDX-License-Identifier: BSL-1.0
// The scene of section 1.5 with your formulas in it: a ball thrown from a roof, beside the same throw in a world.

#include "play.hpp"
#include "plot.hpp"
#include "subject.hpp"

#include <ansatz/world.hpp>

using namespace ansatz;

const auto u = 5.0 * metre_per_second;
const auto g = -9.81 * metre_per_second_squared;

struct Throw {
    Quantity<unit::Time> landing, window_up, window_down;
    std::vector<Quantity<unit::Time>> times;
    std::vector<Quantity<unit::Length>> heights;
};

Throw yours() {
    const auto window = exercise::times_at(1.0 * metre, u, g);
    Throw t{exercise::times_at(-20.0 * metre, u, g).back(), window.front(), window.back(), {}, {}};
    for (int i = 0; i <= 60; ++i) {
        t.times.push_back(i / 60.0 * t.landing);
        t.heights.push_back(20.0 * metre + exercise::after(u, g, t.times.back()).s);
    }
    return t;
}

Throw library() {
    const auto at = [](Quantity<unit::Length> s) {
        return suvat::solve(suvat::displacement(s), suvat::initial_velocity(u), suvat::acceleration(g));
    };
    Throw t{at(-20.0 * metre).back().t, at(1.0 * metre).front().t, at(1.0 * metre).back().t, {}, {}};
    for (int i = 0; i <= 60; ++i) {
        t.times.push_back(i / 60.0 * t.landing);
        const auto motion =
            suvat::solve(suvat::initial_velocity(u), suvat::acceleration(g), suvat::time(t.times.back()));
        t.heights.push_back(20.0 * metre + motion.front().s);
    }
    return t;
}

/// The height of the same ball in a world, stepped to the time of the landing: zero, if the time is right.
double height_in_a_world(Quantity<unit::Time> landing) {
    World world{VelocityVerlet{}, Gravity{metres_per_second_squared(0, -9.81, 0)}};
    const auto ball = world.add(position(metres(0, 20, 0)), velocity(metres_per_second(0, 5, 0)));
    for (int i = 0; i < 100; ++i) world.step(landing / 100.0);
    return y(world.position(ball)).value();
}

int main() {
    workbook::Play table(
        "A ball leaves a roof of 20 m upwards with 5 m/s. It passes a window at 21 m twice, and lands.",
        {"window up, s", "window down, s", "landing, s", "height then in a World, m"});
    table.timed("ns a call");
    workbook::Plot plot("play-motion.suvat", "A throw by formulas: yours and the library's");
    plot.x("time").y("height");
    volatile double sink = 0;
    auto show = [&](const char* who, const Throw& t, auto&& once) {
        plot.line(who, t.times, t.heights);
        table.row(who, {t.window_up.value(), t.window_down.value(), t.landing.value(), height_in_a_world(t.landing)},
                  1000, [&sink, once] {
                      for (int i = 0; i < 1000; ++i) sink = sink + once(-0.01 * i * metre);
                  });
    };
    show("yours", yours(), [](auto s) { return exercise::times_at(s, u, g).back().value(); });
    show("library", library(), [](auto s) {
        return suvat::solve(suvat::displacement(s), suvat::initial_velocity(u), suvat::acceleration(g))
            .back()
            .t.value();
    });
    plot.write();
    return table.print();
}
