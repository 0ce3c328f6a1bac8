// SPDX-License-Identifier: BSL-1.0
// The scene of section 1.6.1 with your integrator in it: a mass on a spring that gains energy at every step.

#include "play.hpp"
#include "oscillation.hpp"
#include "plot.hpp"
#include "subject.hpp"

using namespace ansatz;

const auto omega = 10.0 / second;
const auto dt = 1.0 / 60 * second;

template <class Integrator> void show(const char* who, workbook::Play& table, workbook::Plot& plot) {
    const auto run = problems::oscillate<Integrator>(omega, dt, 180);
    plot.line(who, run.times, run.energies);

    World many{Integrator{}, problems::Oscillator{omega}};
    for (int i = 0; i < 1000; ++i) many.add(position(metres(i, 0, 0)));
    table.row(who, {run.places.back().value(), double(run.energies.back() / run.energies.front())}, 1000,
              [many]() mutable { many.step(1e-3 * second); });
}

int main() {
    workbook::Play table(
        "A mass on a spring, omega = 10/s, 60 steps a second, for 3 s. An energy of 1 would be nature's.",
        {"place, m", "energy, times that at the start"});
    workbook::Plot plot("play-motion.explicit_euler", "Explicit Euler: yours and the library's");
    plot.x("time").y("energy per mass").log_y();
    show<exercise::ExplicitEuler>("yours", table, plot);
    show<ansatz::ExplicitEuler>("library", table, plot);
    plot.write();
    return table.print();
}
