// SPDX-License-Identifier: BSL-1.0
// The scene of section 1.6.2 with your integrator in it: a stiff spring, and what is left of a soft one's energy.

#include "play.hpp"
#include "oscillation.hpp"
#include "plot.hpp"
#include "subject.hpp"

using namespace ansatz;

const auto soft = 10.0 / second, stiff = 1000.0 / second;
const auto dt = 1.0 / 60 * second;

template <class Integrator> void show(const char* who, workbook::Play& table, workbook::Plot& plot) {
    const auto run = problems::oscillate<Integrator>(soft, dt, 60);
    const auto harder = problems::oscillate<Integrator>(stiff, dt, 3);
    plot.line(who, run.times, run.places);

    World many{Integrator{}, problems::Oscillator{soft}};
    for (int i = 0; i < 1000; ++i) many.add(position(metres(i, 0, 0)));
    table.row(who, {double(run.energies.back() / run.energies.front()), harder.places.back().value()}, 1000,
              [many]() mutable { many.step(1.0 / 60 * second); });
}

int main() {
    workbook::Play table(
        "A mass on a spring, let go at 1 m, 60 steps a second: omega = 10/s for a second, and 1000/s (omega "
        "dt = 16.7) for three steps.",
        {"energy left of the soft one", "place of the stiff one, m"});
    workbook::Plot plot("play-motion.implicit_euler", "Implicit Euler: yours and the library's");
    plot.x("time").y("displacement");
    show<exercise::ImplicitEuler>("yours", table, plot);
    show<ansatz::ImplicitEuler>("library", table, plot);
    plot.write();
    return table.print();
}
