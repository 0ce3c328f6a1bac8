// SPDX-License-Identifier: BSL-1.0
// Two skaters on the ice push each other off, one of them held by a wall: your accelerations in steps, and a World.

#include "play.hpp"
#include "plot.hpp"
#include "subject.hpp"

#include <ansatz/world.hpp>

using namespace ansatz;

using Time = Quantity<unit::Time>;
using Length = Quantity<unit::Length>;
using exercise::Act;

const auto dt = 1.0 / 60 * second;
const auto none = metres_per_second_squared(0, 0, 0);
const double masses[] = {0, 50, 80}; // the wall, the first skater, the second
/// What is done in a step: they push each other for half a second, and the wall holds the first one for a second.
std::vector<Act> acts(int step) {
    std::vector<Act> all;
    auto both = [&all](const Act& act) { all.push_back(act), all.push_back(exercise::reaction(act)); };
    if (step < 30) both({1, 2, newtons(40, 0, 0)});
    if (step < 60) both({0, 1, newtons(12, 0, 0)});
    return all;
}

int main() {
    World ice{SemiImplicitEuler{}, AppliedForces{}};
    const Handle bodies[] = {ice.add(fixed), ice.add(mass(masses[1] * kilogram)), ice.add(mass(masses[2] * kilogram))};
    auto velocity = std::vector(3, metres_per_second(0, 0, 0));
    auto place = std::vector(3, metres(0, 0, 0));
    std::vector<Time> times;
    std::vector<Length> first, second_, its_first, its_second;
    for (int step = 0; step < 120; ++step) {
        times.push_back(double(step) * dt);
        first.push_back(x(place[1])), second_.push_back(x(place[2]));
        its_first.push_back(x(ice.position(bodies[1]))), its_second.push_back(x(ice.position(bodies[2])));
        const auto now = acts(step);
        for (int i = 0; i < 3; ++i) {
            const auto inverse_mass = (i == 0 ? 0 : 1 / masses[i]) / kilogram;
            velocity[std::size_t(i)] += exercise::acceleration(exercise::resultant(i, now), inverse_mass, none) * dt;
            place[std::size_t(i)] += velocity[std::size_t(i)] * dt;
        }
        for (const Act& act : now) ice.apply_force(bodies[act.on], act.force);
        ice.step(dt);
    }
    workbook::Play table("Skaters of 50 and 80 kg on the ice push each other off beside a wall, after 2 s: by your "
                         "accelerations, and in a World with AppliedForces",
                         {"the wall, m", "50 kg, m", "80 kg, m"});
    table.timed("ns a step");
    volatile double sink = 0;
    table.row("yours", {x(place[0]).value(), x(place[1]).value(), x(place[2]).value()}, 1, [&sink] {
        const auto now = acts(0);
        for (int i = 0; i < 3; ++i)
            sink = sink + x(exercise::acceleration(exercise::resultant(i, now), 1.0 / kilogram, none)).value();
    });
    table.row(
        "library",
        {x(ice.position(bodies[0])).value(), x(ice.position(bodies[1])).value(), x(ice.position(bodies[2])).value()}, 1,
        [ice, bodies]() mutable {
            for (const Act& act : acts(0)) ice.apply_force(bodies[act.on], act.force);
            ice.step(dt);
        });
    workbook::Plot plot("play-motion.newtons_laws", "Two skaters push each other off, beside a wall");
    plot.x("time").y("place");
    plot.line("50 kg, yours", times, first).line("80 kg, yours", times, second_);
    plot.reference("50 kg, library", times, its_first).reference("80 kg, library", times, its_second);
    plot.write();
    return table.print();
}
