// SPDX-License-Identifier: BSL-1.0
// The scene of section 1.7 with your drag in it: the same second, cut into 30, 60 and 120 steps.

#include "play.hpp"
#include "plot.hpp"
#include "subject.hpp"

#include <ansatz/world.hpp>

using namespace ansatz;

/// What is left of 1 m/s, step by step.
template <class Damping> std::vector<double> slowing_down(int rate, Damping damping) {
    World world{SemiImplicitEuler{}, damping};
    const auto body = world.add(velocity(metres_per_second(1, 0, 0)));
    std::vector<double> left{1};
    for (int i = 0; i < rate; ++i) {
        world.step(1.0 / rate * second);
        left.push_back(in(x(world.velocity(body)), metre_per_second));
    }
    return left;
}

template <class Drag> void show(const char* who, workbook::Play& table, workbook::Plot& plot) {
    std::vector<double> after_a_second;
    for (const int rate : {30, 60, 120}) after_a_second.push_back(slowing_down(rate, Drag{0.603 / second}).back());
    std::vector<Quantity<unit::Time>> times;
    for (int i = 0; i <= 60; ++i) times.push_back(i / 60.0 * second);
    plot.line(who, times, slowing_down(60, Drag{0.603 / second}));

    World many{SemiImplicitEuler{}, Drag{0.603 / second}};
    for (int i = 0; i < 1000; ++i) many.add(velocity(metres_per_second(i, 0, 0)));
    table.row(who, after_a_second, 1000, [many]() mutable { many.step(1e-3 * second); });
}

int main() {
    workbook::Play table("A velocity of 1 m/s under a drag of 0.603/s, after a second. exp(-0.603) is 0.547167.",
                         {"30 steps", "60 steps", "120 steps"});
    workbook::Plot plot("play-motion.drag", "Drag: yours and the library's");
    plot.x("time").y("part of the velocity that is left");
    show<exercise::Drag>("yours", table, plot);
    show<ansatz::Drag>("library", table, plot);
    plot.write();
    return table.print();
}
